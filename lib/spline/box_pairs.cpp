#include "lib/spline/box_pairs.hpp"

#include <CGAL/box_intersection_d.h>

#include <vector>

namespace asts {

namespace {

/// A box as CGAL's search wants it. The search copies and reorders boxes and tells them apart by id() alone.
struct CgalBox {
  using NT = std::int32_t;
  using ID = std::int32_t;

  Box box;
  std::int32_t index;

  static int dimension() { return kDimension; }
  ID id() const { return index; }
  NT min_coord(int axis) const { return box.lower[at(axis)]; }
  NT max_coord(int axis) const { return box.upper[at(axis)]; }
};

/// Below this many boxes CGAL compares all with all.
constexpr std::ptrdiff_t kCutoff = 10;

/// Indices count on from `first`, so that the boxes of two lists can be told apart.
std::vector<CgalBox> convert(std::span<const Box> boxes, std::int32_t first) {
  std::vector<CgalBox> result;
  result.reserve(boxes.size());
  for (const Box& box : boxes) result.push_back({box, first + static_cast<std::int32_t>(result.size())});
  return result;
}

}  // namespace

void for_each_meeting_pair(std::span<const Box> boxes, const BoxPair& meet) {
  std::vector<CgalBox> list = convert(boxes, 0);
  CGAL::box_self_intersection_d(
      list.begin(), list.end(), [&](const CgalBox& a, const CgalBox& b) { meet(a.index, b.index); }, kCutoff,
      CGAL::Box_intersection_d::CLOSED);
}

void for_each_meeting_pair(std::span<const Box> one, std::span<const Box> other, const BoxPair& meet) {
  const auto offset = static_cast<std::int32_t>(one.size());
  std::vector<CgalBox> first = convert(one, 0);
  std::vector<CgalBox> second = convert(other, offset);
  CGAL::box_intersection_d(
      first.begin(), first.end(), second.begin(), second.end(),
      [&](const CgalBox& a, const CgalBox& b) { meet(a.index, b.index - offset); }, kCutoff,
      CGAL::Box_intersection_d::CLOSED);
}

}  // namespace asts
