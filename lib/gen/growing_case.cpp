#include "lib/gen/growing_case.hpp"

#include <algorithm>

#include "lib/refine/refinement.hpp"

namespace asts {

namespace {

std::int64_t cubes_of(const Setting& setting) {
  std::int64_t cubes = 1;
  for (const int side : setting.domain) cubes *= side;
  return cubes;
}

/// Takes cubes away from the axes that have more than p+1, at random, until the initial mesh is small enough.
void shrink_domain(Draw& draw, const CaseLimits& limits, Setting& setting) {
  while (cubes_of(setting) > limits.max_cubes) {
    std::vector<std::size_t> larger;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if (setting.domain[axis] > setting.degree[axis] + 1) larger.push_back(axis);
    }
    if (larger.empty()) return;
    --setting.domain[draw.choose(larger)];
  }
}

}  // namespace

Setting random_setting(Draw& draw, const CaseLimits& limits) {
  Setting setting;
  setting.grading = draw.one_in(2) ? 2 : draw.between(2, limits.max_grading);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    setting.degree[axis] = 1 + 2 * draw.between(1, (limits.max_degree - 1) / 2);
    const int least = setting.degree[axis] + 1;
    setting.domain[axis] = draw.between(least, std::max(least, limits.max_side));
  }
  shrink_domain(draw, limits, setting);
  if (draw.one_in(16)) {
    const std::size_t axis = draw.index(kDimension);
    setting.domain[axis] = draw.between(1, setting.degree[axis]);
  }
  return setting;
}

bool GrowingCase::add(Step::Kind kind, std::span<const std::int32_t> leaves) {
  if (leaves.empty()) return false;
  RefinementTree next = tree_;
  if (kind == Step::Kind::refine) {
    refine(next, leaves);
  } else {
    subdivide_all(next, leaves);
  }
  if (next.element_count() > max_elements_) return false;
  Step step{kind, {}};
  for (const std::int32_t leaf : leaves) step.marks.push_back(lower_corner(tree_, leaf));
  case_.steps.push_back(std::move(step));
  tree_ = std::move(next);
  return true;
}

Point lower_corner(const RefinementTree& tree, std::int32_t element) {
  Point point;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree.grid(axis);
    point[at(axis)] = CompactRational(grid.coordinate(grid.line_of_rank(tree.extent(element, axis).lower)));
  }
  return point;
}

std::vector<std::int32_t> leaves_of(const RefinementTree& tree) {
  std::vector<std::int32_t> leaves;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.is_leaf(id)) leaves.push_back(id);
  }
  return leaves;
}

Point random_point(Draw& draw, const Setting& setting) {
  Point point;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const int denominator = draw.choose(std::vector{1, 2, 4, setting.grading, setting.grading * setting.grading, 7});
    point[axis] = CompactRational(Rational(draw.between(0, setting.domain[axis] * denominator)) / denominator);
  }
  return point;
}

}  // namespace asts
