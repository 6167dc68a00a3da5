#include "lib/refine/patch_search.hpp"

#include <algorithm>

namespace asts {

bool PatchSearch::coarser_in_patches(std::span<const std::int32_t> elements, std::int32_t level, const Found& found) {
  if (elements.empty() || tree_.coarsest(0) >= level) return true;
  const ClusterShape shape(tree_.setting().grading, level);
  return coarser_below(0, shape, Clusters(tree_, shape, elements), found);
}

bool PatchSearch::coarser_below(std::int32_t top, const ClusterShape& shape, const Clusters& clusters,
                                const Found& found) {
  level_ = shape.level();
  const std::vector<Clusters::Entry>& entries = clusters.entries();
  struct Frame {
    std::int32_t end;
    std::size_t first_candidate;
  };
  std::vector<Frame> frames{{static_cast<std::int32_t>(entries.size()), 0}};
  candidates_.assign(1, top);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(entries.size());) {
    const Clusters::Entry& entry = entries[at(i)];
    while (frames.back().end <= i) {
      candidates_.resize(frames.back().first_candidate);
      frames.pop_back();
    }
    if (entry.cluster.members != 0) {
      if (!report_leaves(shape, clusters, i, frames.back().first_candidate, found)) return false;
      ++i;
      continue;
    }
    const std::size_t own = candidates_.size();
    collect_candidates(entry, frames.back().first_candidate, own);
    if (candidates_.size() == own) {
      i = entry.end;
    } else {
      frames.push_back({entry.end, own});
      ++i;
    }
  }
  return true;
}

/// Whether a node meets an open box and has an unmarked leaf below that is coarser than the level searched for.
bool PatchSearch::reaches(std::int32_t candidate, const RankBox& window) const {
  if (tree_.coarsest(candidate) >= level_) return false;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval side = tree_.extent(candidate, axis);
    if (side.upper <= window[at(axis)].lower || side.lower >= window[at(axis)].upper) return false;
  }
  return true;
}

/// Appends the candidates of an entry: those of the entry above that still count, replaced by their children while
/// they are larger than the entry's own node.
void PatchSearch::collect_candidates(const Clusters::Entry& entry, std::size_t from, std::size_t to) {
  const std::int32_t own_level = tree_.level(entry.cluster.root);
  for (std::size_t i = from; i < to; ++i) {
    pending_.assign(1, candidates_[i]);
    while (!pending_.empty()) {
      const std::int32_t id = pending_.back();
      pending_.pop_back();
      if (!reaches(id, entry.window)) continue;
      if (tree_.is_leaf(id) || tree_.level(id) >= own_level) {
        candidates_.push_back(id);
      } else {
        tree_.push_children(id, pending_);
      }
    }
  }
}

bool PatchSearch::report_leaves(const ClusterShape& shape, const Clusters& clusters, std::int32_t number,
                                std::size_t from, const Found& found) {
  const Clusters::Entry& entry = clusters.entries()[at(number)];
  const auto reached = [&](std::int32_t candidate) { return reaches(candidate, entry.window); };
  if (std::none_of(candidates_.begin() + static_cast<std::ptrdiff_t>(from), candidates_.end(), reached)) return true;
  reach_.assign(tree_, shape, entry.cluster);
  collect_leaves(from);
  for (const Leaf& leaf : leaves_) {
    if (!found({leaf.node, number, {entry.cluster.root, leaf.members}, tree_, shape})) return false;
  }
  return true;
}

void PatchSearch::start_from(std::int32_t candidate) {
  if (tree_.coarsest(candidate) >= level_) return;
  Hit hit{candidate, tree_.first_child(candidate), tree_.level(candidate), {}};
  for (Axis axis = 0; axis < kDimension; ++axis) {
    hit.along[at(axis)] = reach_.members_along(axis, tree_.extent(candidate, axis));
  }
  if (hit.members() == 0) return;
  tree_.prefetch_children(hit.first_child);
  hits_.push_back(hit);
}

/// The children of a node that have a leaf to be found below. They differ from the node along one axis only.
void PatchSearch::push_children(const Hit& hit) {
  const Axis axis = hit.level < 0 ? tree_.split_axis(hit.node) : hit.level % kDimension;
  const std::int32_t end = hit.first_child + (hit.level < 0 ? 2 : tree_.setting().grading);
  for (std::int32_t id = hit.first_child; id < end; ++id) {
    if (tree_.coarsest(id) >= level_) continue;
    Hit child = hit;
    child.along[at(axis)] = reach_.members_along(axis, tree_.extent(id, axis));
    if (child.members() == 0) continue;
    child.node = id;
    child.first_child = tree_.first_child(id);
    child.level = hit.level < 0 ? tree_.level(id) : hit.level + 1;
    tree_.prefetch_children(child.first_child);
    deeper_hits_.push_back(child);
  }
}

/// Goes down from the candidates, all of them one step at a time, so that what is read next has been asked for.
void PatchSearch::collect_leaves(std::size_t from) {
  hits_.clear();
  for (std::size_t i = from; i < candidates_.size(); ++i) start_from(candidates_[i]);
  const auto is_inner = [](const Hit& hit) { return hit.first_child != RefinementTree::kNone; };
  while (std::any_of(hits_.begin(), hits_.end(), is_inner)) {
    deeper_hits_.clear();
    for (const Hit& hit : hits_) {
      if (is_inner(hit)) {
        push_children(hit);
      } else {
        deeper_hits_.push_back(hit);  // in its place among the others: the leaves end up in the order of the tree
      }
    }
    hits_.swap(deeper_hits_);
  }
  leaves_.clear();
  for (const Hit& hit : hits_) {
    const std::uint64_t members = hit.members();
    const auto first = static_cast<std::uint64_t>(std::countr_zero(members));
    leaves_.push_back({first << 32U | leaves_.size(), hit.node, members});
  }
  std::sort(leaves_.begin(), leaves_.end(), [](const Leaf& a, const Leaf& b) { return a.order < b.order; });
}

}  // namespace asts
