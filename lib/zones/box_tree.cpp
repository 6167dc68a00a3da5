#include "lib/zones/box_tree.hpp"

#include <bit>

namespace asts {

RankBox BoxTree::nothing() {
  RankBox box;
  box.side.fill({-1, -1});
  return box;
}

RankBox BoxTree::hull_of(const RankBox& one, const RankBox& other) const {
  if (is_nothing(one)) return other;
  if (is_nothing(other)) return one;
  RankBox result = one;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto rank = [&](std::int32_t line) { return tree_->grid(axis).rank_of_line(line); };
    if (rank(other[axis].lower) < rank(one[axis].lower)) result[axis].lower = other[axis].lower;
    if (rank(other[axis].upper) > rank(one[axis].upper)) result[axis].upper = other[axis].upper;
  }
  return result;
}

bool BoxTree::touches(const RankBox& lines, const RankBox& ranks) const {
  if (is_nothing(lines)) return false;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree_->grid(axis);
    const RankInterval side{grid.rank_of_line(lines[axis].lower), grid.rank_of_line(lines[axis].upper)};
    if (!touch(side, ranks[axis])) return false;
  }
  return true;
}

void BoxTree::assign(const std::vector<RankBox>& boxes) {
  count_ = boxes.size();
  leaves_ = std::bit_ceil(std::max<std::size_t>(count_, 1));
  hulls_.assign(2 * leaves_, nothing());
  std::copy(boxes.begin(), boxes.end(), hulls_.begin() + static_cast<std::ptrdiff_t>(leaves_));
  for (std::size_t node = leaves_ - 1; node > 0; --node) hulls_[node] = hull_of(hulls_[2 * node], hulls_[2 * node + 1]);
}

void BoxTree::replace(std::size_t place, const RankBox& box) {
  hulls_[leaves_ + place] = box;
  for (std::size_t node = (leaves_ + place) / 2; node > 0; node /= 2) {
    hulls_[node] = hull_of(hulls_[2 * node], hulls_[2 * node + 1]);
  }
}

}  // namespace asts
