#include "lib/spline/box_pairs.hpp"

#include <CGAL/box_intersection_d.h>

#include <vector>

namespace asts {

namespace {

using CgalBox = CGAL::Box_intersection_d::Box_with_info_d<std::int32_t, kDimension, std::int32_t,
                                                          CGAL::Box_intersection_d::ID_FROM_BOX_ADDRESS>;

/// Below this many boxes CGAL compares all with all.
constexpr std::ptrdiff_t kCutoff = 10;

std::vector<CgalBox> convert(std::span<const Box> boxes) {
  std::vector<CgalBox> result;
  result.reserve(boxes.size());
  for (const Box& box : boxes) {
    PerAxis<std::int32_t> lower = box.lower;
    PerAxis<std::int32_t> upper = box.upper;
    result.emplace_back(lower.data(), upper.data(), static_cast<std::int32_t>(result.size()));
  }
  return result;
}

}  // namespace

void for_each_meeting_pair(std::span<const Box> boxes, const BoxPair& meet) {
  std::vector<CgalBox> list = convert(boxes);
  CGAL::box_self_intersection_d(
      list.begin(), list.end(), [&](const CgalBox& a, const CgalBox& b) { meet(a.info(), b.info()); }, kCutoff,
      CGAL::Box_intersection_d::CLOSED);
}

void for_each_meeting_pair(std::span<const Box> one, std::span<const Box> other, const BoxPair& meet) {
  std::vector<CgalBox> first = convert(one);
  std::vector<CgalBox> second = convert(other);
  CGAL::box_intersection_d(
      first.begin(), first.end(), second.begin(), second.end(),
      [&](const CgalBox& a, const CgalBox& b) { meet(a.info(), b.info()); }, kCutoff,
      CGAL::Box_intersection_d::CLOSED);
}

}  // namespace asts
