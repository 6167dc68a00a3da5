#include "properties/claims/region_points.hpp"

#include <algorithm>

#include "lib/spline/box_pairs.hpp"

namespace asts {

namespace {

/// The coordinate of a line, or the middle of the interval between two.
Rational coordinate_at(const Mesh& mesh, Axis axis, HalfRank position) {
  const Rational& lower = mesh.coordinate(axis, position / 2);
  return position % 2 == 0 ? lower : (lower + mesh.coordinate(axis, position / 2 + 1)) / 2;
}

/// Where membership of boxes can change along an axis, ascending.
std::vector<HalfRank> changes(const std::vector<Box>& one, const std::vector<Box>& other, Axis axis) {
  std::vector<HalfRank> result;
  for (const auto* list : {&one, &other}) {
    for (const Box& box : *list) {
      result.push_back(box.lower[at(axis)]);
      result.push_back(box.upper[at(axis)] + 1);
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

ExactPoint point_at(const Mesh& mesh, const PerAxis<HalfRank>& position) {
  ExactPoint point;
  for (Axis axis = 0; axis < kDimension; ++axis) point[at(axis)] = coordinate_at(mesh, axis, position[at(axis)]);
  return point;
}

bool contains_point(const std::vector<Box>& boxes, const PerAxis<HalfRank>& point) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if (point[axis] < box.lower[axis] || point[axis] > box.upper[axis]) return false;
    }
    return true;
  });
}

/// If there is such a point, going down along each axis to where membership last changed finds another among the points
/// asked.
std::optional<PerAxis<HalfRank>> point_of_difference(const std::vector<Box>& one, const std::vector<Box>& other) {
  PerAxis<std::vector<HalfRank>> ends;
  for (Axis axis = 0; axis < kDimension; ++axis) ends[at(axis)] = changes(one, other, axis);
  for (const HalfRank x : ends[0]) {
    for (const HalfRank y : ends[1]) {
      for (const HalfRank z : ends[2]) {
        if (contains_point(one, {x, y, z}) != contains_point(other, {x, y, z})) return PerAxis<HalfRank>{x, y, z};
      }
    }
  }
  return std::nullopt;
}

std::optional<PerAxis<HalfRank>> common_point(const std::vector<Box>& one, const std::vector<Box>& other) {
  std::optional<PerAxis<HalfRank>> result;
  for_each_meeting_pair(one, other, [&](std::int32_t i, std::int32_t j) {
    PerAxis<HalfRank> point;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      point[axis] = std::max(one[at(i)].lower[axis], other[at(j)].lower[axis]);
    }
    if (!result || point < *result) result = point;
  });
  return result;
}

}  // namespace asts
