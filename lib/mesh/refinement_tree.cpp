#include "lib/mesh/refinement_tree.hpp"

#include <algorithm>
#include <bit>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

/// The place of a coordinate inside an interval, as a fraction: the interval's start + (rest / denominator) * length.
/// Going down to the child that contains it is a division with remainder, exact at any depth.
template <typename Number>
struct Place {
  Number rest;
  Number denominator;

  std::int32_t descend(int parts) {
    rest *= parts;
    std::int32_t child = static_cast<std::int32_t>(Number(rest / denominator));
    child = std::min(child, parts - 1);  // the domain's upper face belongs to the last element
    rest -= denominator * child;
    return child;
  }
};

template <typename Number>
std::int32_t descend_to_leaf(const RefinementTree& tree, const PerAxis<Number>& numerator,
                             const PerAxis<Number>& denominator) {
  PerAxis<Place<Number>> place;
  PerAxis<std::int32_t> cube{};
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const int last = tree.setting().domain[axis] - 1;
    cube[axis] = std::min(static_cast<std::int32_t>(Number(numerator[axis] / denominator[axis])), last);
    place[axis] = {numerator[axis] - denominator[axis] * cube[axis], denominator[axis]};
  }
  std::int32_t id = tree.unit_cube(cube);
  while (!tree.is_leaf(id)) {
    const auto axis = at(tree.split_axis(id));
    id = tree.first_child(id) + place[axis].descend(tree.setting().grading);
  }
  return id;
}

}  // namespace

RefinementTree::RefinementTree(const Setting& setting) : setting_(setting) {
  std::int64_t cubes = 1;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    require(setting.domain[axis] >= 1, "the domain needs at least one cube along each axis");
    cubes *= setting.domain[axis];
    if (cubes > kMaxInitialElements) throw ResourceError("the initial mesh has too many elements");
    grids_.emplace_back(setting.domain[axis], setting.grading, setting.degree[axis]);
  }
  element_count_ = initial_left_ = cubes;
  unit_cubes_.assign(static_cast<std::size_t>(cubes), kNone);
  build_blocks();
  initial_nodes_ = node_count();
}

Axis RefinementTree::longest_block_axis(std::int32_t block) const {
  Axis longest = 0;
  const auto units = [&](Axis axis) { return grid(axis).units_in(cell(block, axis)); };
  for (Axis axis = 1; axis < kDimension; ++axis) {
    if (units(axis) > units(longest)) longest = axis;
  }
  return longest;
}

std::int32_t RefinementTree::block_level(const PerAxis<std::int32_t>& cells) const {
  std::int32_t halvings = 0;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto units = static_cast<std::uint32_t>(grid(axis).units_in(cells[at(axis)]));
    halvings += static_cast<std::int32_t>(std::bit_width(units - 1));
  }
  return -halvings;
}

void RefinementTree::build_blocks() {
  PerAxis<std::int32_t> root{};
  for (Axis axis = 0; axis < kDimension; ++axis) root[at(axis)] = grid(axis).root();
  push_node({root, kNone, kNone, block_level(root), 0});
  for (std::int32_t id = 0; id < node_count(); ++id) {
    if (node(id).level < 0) {
      halve(id);
      continue;
    }
    std::size_t index = 0;
    for (Axis axis = kDimension - 1; axis >= 0; --axis) {
      index = index * at(setting_.domain[at(axis)]) + at(extent(id, axis).lower);  // rank i is the integer i here
    }
    unit_cubes_[index] = id;
  }
}

void RefinementTree::halve(std::int32_t block) {
  const auto split = at(split_axis(block));
  Node half = node(block);
  half.cell[split] = grids_[split].children(half.cell[split]);
  places_[at(block)].first_child = node_count();
  half.parent = block;
  half.first_child = kNone;
  for (int i = 0; i < 2; ++i, ++half.cell[split]) {
    half.level = block_level(half.cell);
    push_node(half);
  }
}

void RefinementTree::push_node(const Node& node) {
  places_.push_back({node.cell, node.first_child});
  links_.push_back({node.parent, node.level});
  coarsest_.push_back(node.coarsest);
}

std::int32_t RefinementTree::unit_cube(const PerAxis<std::int32_t>& index) const {
  std::size_t place = 0;
  for (std::size_t axis = kDimension; axis-- > 0;) {
    place = place * at(setting_.domain[axis]) + at(index[axis]);
  }
  return unit_cubes_[place];
}

std::int32_t RefinementTree::leaf_at(const Point& point) const {
  PerAxis<std::int64_t> numerator{};
  PerAxis<std::int64_t> denominator{};
  bool fits = true;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (!point[axis].is_small()) {
      fits = false;
      break;
    }
    numerator[axis] = point[axis].numerator();
    denominator[axis] = point[axis].denominator();
    // rest <= denominator, so rest * m must not overflow
    fits = fits && denominator[axis] <= std::numeric_limits<std::int64_t>::max() / setting_.grading;
  }
  if (fits) return descend_to_leaf(*this, numerator, denominator);
  PerAxis<Integer> wide_numerator;
  PerAxis<Integer> wide_denominator;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const Rational value = point[axis].value();
    wide_numerator[axis] = boost::multiprecision::numerator(value);
    wide_denominator[axis] = boost::multiprecision::denominator(value);
  }
  return descend_to_leaf(*this, wide_numerator, wide_denominator);
}

void RefinementTree::update_ranks() {
  for (AxisGrid& axis_grid : grids_) axis_grid.update_ranks();
}

/// Sets a node's coarsest level and carries the change upwards, to `top` at most, as far as it matters.
void RefinementTree::set_coarsest(std::int32_t id, std::int32_t level, std::int32_t top) {
  coarsest_[at(id)] = level;
  while (id != top) {
    const std::int32_t parent = links_[at(id)].parent;
    const std::int32_t before = coarsest_[at(parent)];
    if (level > before) level = coarsest_sibling(id, before);
    if (level == before) return;
    coarsest_[at(parent)] = level;
    id = parent;
  }
}

/// The minimum over a node and its siblings; ends early at `bound`, below which none of them is.
std::int32_t RefinementTree::coarsest_sibling(std::int32_t id, std::int32_t bound) const {
  const bool initial = id < initial_nodes_;
  const std::int32_t first = initial ? id - (id - 1) % 2 : id - child_number(id);
  const std::int32_t count = initial ? 2 : setting_.grading;
  std::int32_t coarsest = kNoLevel;
  for (std::int32_t child = first; child < first + count && coarsest > bound; ++child) {
    coarsest = std::min(coarsest, coarsest_[at(child)]);
  }
  return coarsest;
}

}  // namespace asts
