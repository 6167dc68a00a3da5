#include "lib/refine/patch_search.hpp"

#include <algorithm>

namespace asts {

bool PatchSearch::coarser_in_patches(std::span<const std::int32_t> elements, std::int32_t level, const Found& found) {
  if (elements.empty() || tree_.node(0).coarsest >= level) return true;
  level_ = level;
  span_subtree(elements);
  append_entries(level);

  struct Frame {
    std::int32_t end;
    std::size_t first_candidate;
  };
  std::vector<Frame> frames{{static_cast<std::int32_t>(entries_.size()), 0}};
  candidates_.assign(1, 0);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(entries_.size());) {
    const Entry& entry = entries_[at(i)];
    while (frames.back().end <= i) {
      candidates_.resize(frames.back().first_candidate);
      frames.pop_back();
    }
    const std::size_t own = candidates_.size();
    collect_candidates(entry, frames.back().first_candidate, own);
    const bool is_element = tree_.node(entry.node).level == level;
    if (is_element && !report_leaves(entry, own, found)) return false;
    if (is_element || candidates_.size() == own) {
      candidates_.resize(own);
      i = entry.end;
    } else {
      frames.push_back({entry.end, own});
      ++i;
    }
  }
  return true;
}

/// Stamps the elements and all nodes above them.
void PatchSearch::span_subtree(std::span<const std::int32_t> elements) {
  ++epoch_;
  stamp_.resize(at(tree_.node_count()), 0);
  for (const std::int32_t element : elements) {
    for (std::int32_t id = element; id != RefinementTree::kNone && stamp_[at(id)] != epoch_;
         id = tree_.node(id).parent) {
      stamp_[at(id)] = epoch_;
    }
  }
}

/// Lists the stamped subtree in preorder and gives each node the bounding box of the environments below it.
void PatchSearch::append_entries(std::int32_t level) {
  entries_.clear();
  pending_.assign(1, 0);
  std::vector<std::int32_t> open;  // entries whose subtree is not complete
  const auto close_top = [&] {
    const Extent below = entries_[at(open.back())].window;
    entries_[at(open.back())].end = static_cast<std::int32_t>(entries_.size());
    open.pop_back();
    if (open.empty()) return;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      RankInterval& side = entries_[at(open.back())].window.side[axis];
      side.lower = std::min(side.lower, below.side[axis].lower);
      side.upper = std::max(side.upper, below.side[axis].upper);
    }
  };
  while (!pending_.empty()) {
    const std::int32_t id = pending_.back();
    pending_.pop_back();
    while (!open.empty() && entries_[at(open.back())].node != tree_.node(id).parent) close_top();
    open.push_back(static_cast<std::int32_t>(entries_.size()));
    Entry& entry = entries_.emplace_back(Entry{id, 0, {}});
    const bool is_element = tree_.node(id).level == level;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      entry.window.side[at(axis)] =
          is_element ? tree_.environment(id, axis) : RankInterval{std::numeric_limits<std::int32_t>::max(), 0};
    }
    if (is_element) continue;
    const std::int32_t first = tree_.node(id).first_child;
    for (std::int32_t child = first + tree_.child_count(id) - 1; child >= first; --child) {
      if (stamp_[at(child)] == epoch_) pending_.push_back(child);
    }
  }
  while (!open.empty()) close_top();
}

/// Whether a node meets an open box and has an unmarked leaf below that is coarser than the level searched for. A leaf
/// is the closure of its interior, so it meets an open box exactly if the interiors do.
bool PatchSearch::reaches(std::int32_t candidate, const Extent& window) const {
  if (tree_.node(candidate).coarsest >= level_) return false;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval side = tree_.extent(candidate, axis);
    if (side.upper <= window.side[at(axis)].lower || side.lower >= window.side[at(axis)].upper) return false;
  }
  return true;
}

/// Appends the candidates of an entry: those of the entry above that still count, replaced by their children while
/// they are larger than the entry's own node.
void PatchSearch::collect_candidates(const Entry& entry, std::size_t from, std::size_t to) {
  const std::int32_t own_level = tree_.node(entry.node).level;
  for (std::size_t i = from; i < to; ++i) {
    pending_.assign(1, candidates_[i]);
    while (!pending_.empty()) {
      const std::int32_t id = pending_.back();
      pending_.pop_back();
      if (!reaches(id, entry.window)) continue;
      if (tree_.is_leaf(id) || tree_.node(id).level >= own_level) {
        candidates_.push_back(id);
      } else {
        tree_.push_children(id, pending_);
      }
    }
  }
}

bool PatchSearch::report_leaves(const Entry& entry, std::size_t from, const Found& found) {
  for (std::size_t i = from; i < candidates_.size(); ++i) {
    pending_.assign(1, candidates_[i]);
    while (!pending_.empty()) {
      const std::int32_t id = pending_.back();
      pending_.pop_back();
      if (!reaches(id, entry.window)) continue;
      if (!tree_.is_leaf(id)) {
        tree_.push_children(id, pending_);
      } else if (!found(entry.node, id)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace asts
