#include "lib/spline/dual_compatibility.hpp"

#include <algorithm>

#include "lib/spline/axis_overlap.hpp"

namespace asts {

namespace {

/// The indices that show, along an axis, that two bricks fail to overlap, or that they meet.
std::pair<std::int32_t, std::int32_t> telling_indices(const TSplines& splines, const AxisProfile& one,
                                                      const AxisProfile& other, Axis axis) {
  std::vector<std::int32_t> missing;
  append_missing(one.entries, other.entries, missing);
  if (!missing.empty()) {
    return {index_with_entry(splines, one, axis, missing.front()), index_around(splines, other, axis, missing.front())};
  }
  append_missing(other.entries, one.entries, missing);
  if (!missing.empty()) {
    return {index_around(splines, one, axis, missing.front()), index_with_entry(splines, other, axis, missing.front())};
  }
  return indices_meeting(splines, one, other, axis);
}

NodePair telling_nodes(const TSplines& splines, const Bricks& bricks, const Brick& one, const Brick& other) {
  PerAxis<std::int32_t> v;
  PerAxis<std::int32_t> w;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    std::tie(v[at(axis)], w[at(axis)]) =
        telling_indices(splines, bricks.profile(one, axis), bricks.profile(other, axis), axis);
  }
  const std::int32_t first = bricks.node(one, v);
  const std::int32_t second = bricks.node(other, w);
  return {std::min(first, second), std::max(first, second)};
}

}  // namespace

std::optional<NodePair> find_incompatible(const TSplines& splines, const Bricks& bricks) {
  std::vector<AxisOverlap> overlaps;
  for (Axis axis = 0; axis < kDimension; ++axis) overlaps.emplace_back(bricks, axis);
  std::optional<std::pair<std::int32_t, std::int32_t>> least;
  for (const auto& pair : bricks.pairs) {
    const Brick& one = bricks.bricks[at(pair.first)];
    const Brick& other = bricks.bricks[at(pair.second)];
    if (!interiors_meet(one.support, other.support)) continue;
    int overlapping = 0;
    for (AxisOverlap& overlap : overlaps) overlapping += overlap.holds(one, other) ? 1 : 0;
    if (overlapping < 2 && (!least || pair < *least)) least = pair;
  }
  if (!least) return std::nullopt;
  return telling_nodes(splines, bricks, bricks.bricks[at(least->first)], bricks.bricks[at(least->second)]);
}

}  // namespace asts
