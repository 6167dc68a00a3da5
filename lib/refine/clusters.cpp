#include "lib/refine/clusters.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "lib/threads/parallel_for.hpp"

namespace asts {

/// The nodes above the element met last, up to its root: the next one mostly has some of them, too.
struct Clusters::Path {
  std::array<std::int32_t, ClusterShape::kMostHeight + 1> node;
  std::array<int, ClusterShape::kMostHeight + 1> first{};  ///< the lowest bit below the node

  Path() { node.fill(RefinementTree::kNone); }
};

Clusters::Clusters(const RefinementTree& tree, const ClusterShape& shape, std::span<const std::int32_t> elements,
                   int jobs)
    : tree_(tree), shape_(shape) {
  if (elements.empty()) return;
  gather(elements, jobs);
  span_upwards();
  list_entries();
}

/// Each thread gathers parts of clusters from elements that stand next to each other; then parts with the same root
/// are put together, in their order.
void Clusters::gather(std::span<const std::int32_t> elements, int jobs) {
  constexpr std::size_t kChunk = 8192;
  constexpr std::size_t kAhead = 16;
  std::vector<std::vector<Cluster>> parts((elements.size() + kChunk - 1) / kChunk);
  parallel_for(jobs, parts.size(), [&](std::size_t chunk, int) {
    Path path;
    std::vector<Cluster> own;
    const std::size_t end = std::min(elements.size(), (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i) {
      if (i + kAhead < end) tree_.prefetch(elements[i + kAhead]);
      add_member(elements[i], path, own);
    }
    parts[chunk] = std::move(own);
  });
  for (const std::vector<Cluster>& of_chunk : parts) {
    for (const Cluster& part : of_chunk) {
      const auto [index, is_new] = spanned_.insert(part.root);
      if (is_new) members_.push_back(0);
      members_[at(index)] |= part.members;
    }
  }
}

/// Climbs from an element until it meets the path, which it changes so that it leads to this element. `parts` ends with
/// the part of the path's root.
void Clusters::add_member(std::int32_t element, Path& path, std::vector<Cluster>& parts) const {
  std::array<int, ClusterShape::kMostHeight> number;  // of each node on the way among its siblings
  const std::size_t top = at(shape_.height());
  std::size_t height = 0;
  std::int32_t id = element;
  int below = 1;  // members below a node of the height
  for (; height < top && path.node[height] != id; ++height) {
    path.node[height] = id;
    number[height] = tree_.child_number(id);
    below *= tree_.setting().grading;
    id = tree_.parent(id);
  }
  if (path.node[height] != id) {  // another root
    path.node[height] = id;
    parts.push_back({id, 0});
  }
  while (height-- > 0) {
    below /= tree_.setting().grading;
    path.first[height] = path.first[height + 1] + number[height] * below;
  }
  parts.back().members |= std::uint64_t{1} << path.first[0];
}

void Clusters::span_upwards() {
  const std::int32_t clusters = spanned_.size();
  for (std::int32_t cluster = 0; cluster < clusters; ++cluster) {
    std::int32_t id = tree_.parent(spanned_.node(cluster));
    while (id != RefinementTree::kNone && spanned_.insert(id).second) id = tree_.parent(id);
  }
  members_.resize(at(spanned_.size()), 0);
}

/// Lists the spanned nodes in preorder, each with the bounding box of what is below.
void Clusters::list_entries() {
  constexpr RankInterval kNowhere{std::numeric_limits<std::int32_t>::max(), 0};
  entries_.reserve(members_.size());
  std::vector<std::int32_t> pending(1, 0);
  std::vector<std::int32_t> open;  // entries whose subtree is not complete
  const auto close_top = [&] {
    Entry& complete = entries_[at(open.back())];
    complete.end = static_cast<std::int32_t>(entries_.size());
    open.pop_back();
    if (open.empty()) return;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      RankInterval& side = entries_[at(open.back())].window[axis];
      side.lower = std::min(side.lower, complete.window[axis].lower);
      side.upper = std::max(side.upper, complete.window[axis].upper);
    }
  };
  while (!pending.empty()) {
    const std::int32_t id = pending.back();
    pending.pop_back();
    while (!open.empty() && entries_[at(open.back())].cluster.root != tree_.parent(id)) close_top();
    open.push_back(static_cast<std::int32_t>(entries_.size()));
    Entry& entry = entries_.emplace_back(Entry{{id, members_[at(spanned_.find(id))]}, 0, {}});
    if (entry.cluster.members != 0) {
      entry.window = shape_.window(tree_, entry.cluster);
      continue;
    }
    entry.window.fill(kNowhere);
    const std::int32_t first = tree_.first_child(id);
    for (std::int32_t child = first + tree_.child_count(id) - 1; child >= first; --child) {
      if (spanned_.find(child) != NodeTable::kNone) pending.push_back(child);
    }
  }
  while (!open.empty()) close_top();
}

}  // namespace asts
