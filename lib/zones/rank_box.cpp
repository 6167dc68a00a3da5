#include "lib/zones/rank_box.hpp"

namespace asts {

RankInterval active_range(const RefinementTree& tree, Axis axis) {
  const std::int32_t margin = (tree.setting().degree[at(axis)] + 1) / 2;
  const std::int32_t upper = tree.setting().domain[at(axis)] - margin;
  if (upper < margin) return {1, 0};
  return {tree.grid(axis).rank_of_line(margin), tree.grid(axis).rank_of_line(upper)};
}

bool active_region_is_empty(const RefinementTree& tree) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval range = active_range(tree, axis);
    if (range.lower > range.upper) return true;
  }
  return false;
}

}  // namespace asts
