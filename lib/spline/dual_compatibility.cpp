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

/// Along how many axes bricks overlap.
class OverlapCount {
 public:
  explicit OverlapCount(const Bricks& bricks) {
    for (Axis axis = 0; axis < kDimension; ++axis) overlaps_.emplace_back(bricks, axis);
  }

  int of(const Brick& one, const Brick& other) {
    int overlapping = 0;
    for (AxisOverlap& overlap : overlaps_) overlapping += overlap.holds(one, other) ? 1 : 0;
    return overlapping;
  }

 private:
  std::vector<AxisOverlap> overlaps_;
};

std::optional<NodePair> least_incompatible(const TSplines& splines, const Bricks& bricks, bool sharing_volume) {
  OverlapCount overlapping(bricks);
  std::optional<std::pair<std::int32_t, std::int32_t>> least;
  for (const auto& pair : bricks.pairs) {
    const Brick& one = bricks.bricks[at(pair.first)];
    const Brick& other = bricks.bricks[at(pair.second)];
    if (sharing_volume && !interiors_meet(one.support, other.support)) continue;
    if (overlapping.of(one, other) < 2 && (!least || pair < *least)) least = pair;
  }
  if (!least) return std::nullopt;
  return telling_nodes(splines, bricks, bricks.bricks[at(least->first)], bricks.bricks[at(least->second)]);
}

}  // namespace

std::optional<NodePair> find_incompatible(const TSplines& splines, const Bricks& bricks) {
  return least_incompatible(splines, bricks, true);
}

std::optional<NodePair> find_incompatible_meeting(const TSplines& splines, const Bricks& bricks) {
  return least_incompatible(splines, bricks, false);
}

std::int64_t count_overlap_failures(const Bricks& bricks) {
  OverlapCount overlapping(bricks);
  return std::count_if(bricks.pairs.begin(), bricks.pairs.end(), [&](const auto& pair) {
    const Brick& one = bricks.bricks[at(pair.first)];
    const Brick& other = bricks.bricks[at(pair.second)];
    return interiors_meet(one.support, other.support) && overlapping.of(one, other) < kDimension;
  });
}

}  // namespace asts
