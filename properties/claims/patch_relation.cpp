#include "properties/claims/patch_relation.hpp"

#include <algorithm>

namespace asts {

namespace {

Elements members(const std::vector<bool>& belongs) {
  Elements result;
  for (std::size_t id = 0; id < belongs.size(); ++id) {
    if (belongs[id]) result.push_back(static_cast<std::int32_t>(id));
  }
  return result;
}

}  // namespace

bool in_patch(const RefinementTree& tree, std::int32_t k, std::int32_t element) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval closed = tree.extent(element, axis);
    const RankInterval open = tree.environment(k, axis);
    if (closed.upper <= open.lower || closed.lower >= open.upper) return false;
  }
  return true;
}

CoarserInPatches::CoarserInPatches(const RefinementTree& tree)
    : leaves_(leaves_in_order(tree)), coarser_(at(tree.node_count())) {
  for (const std::int32_t k : leaves_) {
    for (const std::int32_t other : leaves_) {
      if (tree.node(other).level < tree.node(k).level && in_patch(tree, k, other)) coarser_[at(k)].push_back(other);
    }
  }
}

Elements least_closed_superset(const CoarserInPatches& patches, const Elements& marks) {
  std::vector<bool> reached(patches.node_count(), false);
  Elements pending = marks;
  while (!pending.empty()) {
    const std::int32_t k = pending.back();
    pending.pop_back();
    if (reached[at(k)]) continue;
    reached[at(k)] = true;
    pending.insert(pending.end(), patches.of(k).begin(), patches.of(k).end());
  }
  return members(reached);
}

Elements closure_as_printed(const CoarserInPatches& patches, const Elements& marks, const Elements& order) {
  std::vector<bool> marked(patches.node_count(), false);
  for (const std::int32_t mark : marks) marked[at(mark)] = true;
  for (bool grew = true; grew;) {
    grew = false;
    for (const std::int32_t k : order) {
      if (!marked[at(k)]) continue;
      for (const std::int32_t coarser : patches.of(k)) {
        grew = grew || !marked[at(coarser)];
        marked[at(coarser)] = true;
      }
    }
  }
  return members(marked);
}

}  // namespace asts
