#include "lib/refine/cluster_shape.hpp"

namespace asts {

namespace {

constexpr int kMostMembers = 64;

}  // namespace

ClusterShape::ClusterShape(int grading, std::int32_t level) : grading_(grading), level_(level) {
  int capacity = 1;
  for (; height_ < level && capacity <= kMostMembers / grading; ++height_) capacity *= grading;
  for (std::vector<std::uint64_t>& places : at_place_) places.assign(1, 0);
  for (std::int32_t h = height_; h > 0; --h) {  // an element h levels above the members is split
    std::vector<std::uint64_t>& places = at_place_[at((level - h) % kDimension)];
    places.resize(places.size() * at(grading), 0);
  }
  for (int bit = 0; bit < capacity; ++bit) {
    PerAxis<std::size_t> place{};
    int below = capacity;
    for (std::int32_t h = height_; h > 0; --h) {
      below /= grading;
      std::size_t& along = place[at((level - h) % kDimension)];
      along = along * at(grading) + at(bit / below % grading);
    }
    for (std::size_t axis = 0; axis < kDimension; ++axis) at_place_[axis][place[axis]] |= std::uint64_t{1} << bit;
  }
}

RankInterval ClusterShape::window(const RefinementTree& tree, std::int32_t root, Axis axis, std::int32_t i) const {
  const AxisGrid& grid = tree.grid(axis);
  std::int32_t cell = tree.cell(root, axis);
  for (std::int32_t below = places(axis); below > 1;) {
    below /= grading_;
    cell = grid.known_children(cell) + i / below % grading_;
  }
  return grid.window(cell);
}

RankBox ClusterShape::window(const RefinementTree& tree, const Cluster& cluster) const {
  RankBox box;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    std::int32_t first = 0;
    std::int32_t last = places(axis) - 1;
    while ((members_at(axis, first) & cluster.members) == 0) ++first;
    while ((members_at(axis, last) & cluster.members) == 0) --last;
    // Windows of cells of one depth lie in the order of the cells.
    box[at(axis)] = {window(tree, cluster.root, axis, first).lower, window(tree, cluster.root, axis, last).upper};
  }
  return box;
}

std::int32_t ClusterShape::member(const RefinementTree& tree, std::int32_t root, int bit) const {
  int below = 1;
  for (std::int32_t h = 0; h < height_; ++h) below *= grading_;
  std::int32_t id = root;
  for (std::int32_t h = 0; h < height_; ++h) {
    below /= grading_;
    id = tree.first_child(id) + bit / below % grading_;
  }
  return id;
}

}  // namespace asts
