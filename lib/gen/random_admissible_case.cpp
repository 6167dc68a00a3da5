#include <algorithm>

#include "lib/gen/biased_cases.hpp"

namespace asts {

namespace {

using Leaves = std::vector<std::int32_t>;

void make_distinct(Leaves& leaves) {
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
}

Leaves anywhere(Draw& draw, const RefinementTree& tree) {
  Leaves leaves;
  for (int count = draw.between(1, 4); count > 0; --count) {
    leaves.push_back(tree.leaf_at(random_point(draw, tree.setting())));
  }
  return leaves;
}

/// Leaves at points less than one unit from the centre along each axis.
Leaves near(Draw& draw, const RefinementTree& tree, const Point& centre) {
  Leaves leaves;
  for (int count = draw.between(1, 5); count > 0; --count) {
    Point point;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      const Rational moved = centre[axis].value() + Rational(draw.between(-8, 8)) / 9;
      point[axis] = CompactRational(std::clamp(moved, Rational(0), Rational(tree.setting().domain[axis])));
    }
    leaves.push_back(tree.leaf_at(point));
  }
  return leaves;
}

std::int32_t deepest(Draw& draw, const RefinementTree& tree) {
  Leaves deep;
  for (const std::int32_t leaf : leaves_of(tree)) {
    if (tree.node(leaf).level == tree.max_level()) deep.push_back(leaf);
  }
  return draw.choose(deep);
}

Point corner(Draw& draw, const Setting& setting) {
  Point point;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    point[axis] = CompactRational(draw.one_in(2) ? 0 : setting.domain[axis]);
  }
  return point;
}

}  // namespace

RandomCase admissible_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits, Bias bias) {
  const Point centre = bias == Bias::marks_corner ? corner(draw, setting) : random_point(draw, setting);
  GrowingCase growing(setting, limits.max_elements);
  for (int steps = draw.between(1, limits.max_steps); steps > 0; --steps) {
    Leaves marks;
    switch (bias) {
      case Bias::marks_clustered:
        marks = near(draw, growing.tree(), centre);
        break;
      case Bias::marks_corner:
        marks = {growing.tree().leaf_at(centre)};
        break;
      case Bias::marks_deep:
        marks = {deepest(draw, growing.tree())};
        break;
      default:
        marks = anywhere(draw, growing.tree());
    }
    make_distinct(marks);
    if (!growing.add(Step::Kind::refine, marks)) break;
  }
  return {growing.content(), bias};
}

RandomCase random_admissible_case(Draw& draw, const CaseLimits& limits) {
  const Bias bias =
      draw.choose(std::vector{Bias::marks_anywhere, Bias::marks_clustered, Bias::marks_corner, Bias::marks_deep});
  return admissible_case_in(draw, random_setting(draw, limits), limits, bias);
}

}  // namespace asts
