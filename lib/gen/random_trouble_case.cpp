#include <algorithm>

#include "lib/gen/biased_cases.hpp"
#include "lib/gen/smaller_patch.hpp"
#include "lib/refine/refinement.hpp"

namespace asts {

namespace {

using Leaves = std::vector<std::int32_t>;

constexpr int kGradedSteps = 12;
constexpr std::int64_t kGradedElements = 900;

void make_distinct(Leaves& leaves) {
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
}

/// Part of the domain's boundary: points of it have these coordinates where `fixed`, any others elsewhere.
struct BoundaryPart {
  PerAxis<bool> fixed{};
  Point at_side;
};

/// A face has one coordinate fixed, an edge two.
BoundaryPart random_boundary_part(Draw& draw, const Setting& setting, std::size_t fixed) {
  BoundaryPart part;
  std::vector<std::size_t> axes{0, 1, 2};
  draw.shuffle(axes);
  for (std::size_t i = 0; i < fixed; ++i) {
    part.fixed[axes[i]] = true;
    part.at_side[axes[i]] = CompactRational(draw.one_in(2) ? 0 : setting.domain[axes[i]]);
  }
  return part;
}

/// Few elements along the part in one step, or many: then the closure reaches far into the domain.
Leaves along(Draw& draw, const RefinementTree& tree, const BoundaryPart& part) {
  Leaves leaves;
  for (int count = draw.one_in(3) ? 12 : draw.between(1, 3); count > 0; --count) {
    Point point = random_point(draw, tree.setting());
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if (part.fixed[axis]) point[axis] = part.at_side[axis];
    }
    leaves.push_back(tree.leaf_at(point));
  }
  make_distinct(leaves);
  return leaves;
}

void refine_along(Draw& draw, GrowingCase& growing, int steps, std::size_t fixed) {
  const BoundaryPart part = random_boundary_part(draw, growing.tree().setting(), fixed);
  for (; steps > 0; --steps) {
    if (!growing.add(Step::Kind::refine, along(draw, growing.tree(), part))) return;
  }
}

void refine_all(GrowingCase& growing, int steps) {
  for (; steps > 0; --steps) {
    if (!growing.add(Step::Kind::refine, leaves_of(growing.tree()))) return;
  }
}

/// Twelve steps, most of them at one point.
void refine_graded(Draw& draw, GrowingCase& growing) {
  const Point focus = random_point(draw, growing.tree().setting());
  for (int step = 0; step < kGradedSteps; ++step) {
    const Point mark = step < 2 || !draw.one_in(4) ? focus : random_point(draw, growing.tree().setting());
    const std::int32_t leaf = growing.tree().leaf_at(mark);
    growing.add(Step::Kind::refine, {&leaf, 1});
  }
}

/// Subdivides smaller closures, of elements for which it makes a difference where there are such.
void subdivide_smaller_closures(Draw& draw, GrowingCase& growing, int steps) {
  for (; steps > 0; --steps) {
    Leaves chosen;
    for (int tries = 8; tries > 0; --tries) {
      const std::int32_t mark =
          tries % 2 == 0 ? draw.choose(leaves_of(growing.tree())) : leaf_below(draw, growing.tree(), 0);
      RefinementTree copy = growing.tree();
      const std::size_t wanted = mark_closure(copy, std::vector{mark}).size();
      chosen = smaller_closure(growing.tree(), std::vector{mark});
      if (chosen.size() < wanted) break;
    }
    make_distinct(chosen);
    if (!growing.add(Step::Kind::subdivide, chosen)) return;
  }
}

std::size_t longest_axis(const Setting& setting) {
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < kDimension; ++axis) {
    const auto excess = [&](std::size_t a) { return setting.domain[a] - 2 * setting.degree[a]; };
    if (excess(axis) > excess(longest)) longest = axis;
  }
  return longest;
}

/// Levels fall with the distance from one cube, at random and with gaps. Every other column is bare but for that cube
/// and a pair of cubes beyond a gap, and every other one stands in the centre: so do meshes that are dual-compatible
/// and not analysis-suitable, which are rare.
Column random_column(Draw& draw, const Setting& setting) {
  Column column;
  column.axis = longest_axis(setting);
  column.cube = middle_cube(draw, setting);
  if (draw.one_in(2)) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) column.cube[axis] = setting.domain[axis] / 2;
  }
  const int length = setting.domain[column.axis];
  const int peak = draw.between(0, length - 1);
  const int top = draw.between(2, 3);
  const bool pair = draw.one_in(2);
  const int step = draw.one_in(2) ? 1 : -1;
  for (int place = 0; place < length; ++place) {
    const int most = std::max(0, top - (std::abs(place - peak) + 2) / 3);
    const int distance = step * (place - peak);
    const int level = pair ? (distance == 2 || distance == 3 ? 1 : 0) : draw.one_in(3) ? 0 : draw.between(0, most);
    column.levels.push_back(place == peak ? top : level);
  }
  return column;
}

/// Whether an element lies in a closed box of points.
bool lies_in(const RefinementTree& tree, std::int32_t id, const PerAxis<int>& lower, const PerAxis<int>& upper) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree.grid(axis);
    const RankInterval side = tree.extent(id, axis);
    if (grid.coordinate(grid.line_of_rank(side.lower)) < lower[at(axis)]) return false;
    if (grid.coordinate(grid.line_of_rank(side.upper)) > upper[at(axis)]) return false;
  }
  return true;
}

/// Subdivides all elements but those in one or two boxes of unit cubes, each more than half as long as the domain
/// along one axis at least, again and again with other boxes.
void leave_holes(Draw& draw, GrowingCase& growing, int steps) {
  const Setting& setting = growing.tree().setting();
  for (; steps > 0; --steps) {
    Leaves chosen = leaves_of(growing.tree());
    for (int holes = draw.between(1, 2); holes > 0; --holes) {
      PerAxis<int> lower{};
      PerAxis<int> upper{};
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        lower[axis] = draw.between(0, setting.domain[axis] - 1);
        upper[axis] = draw.between(lower[axis] + 1, setting.domain[axis]);
      }
      std::erase_if(chosen, [&](std::int32_t leaf) { return lies_in(growing.tree(), leaf, lower, upper); });
    }
    if (!growing.add(Step::Kind::subdivide, chosen)) return;
  }
}

/// Steps of every kind near a small active region.
RandomCase in_small_region(Draw& draw, const Setting& setting, const CaseLimits& limits) {
  return random_case_in(draw, setting, limits,
                        draw.choose(std::vector{Bias::marks_clustered, Bias::marks_deep, Bias::bare_scattered,
                                                Bias::bare_stacked, Bias::bare_touching, Bias::bare_one_left_out}));
}

}  // namespace

void subdivide_column(Draw& draw, GrowingCase& growing, const Column& column) {
  PerAxis<bool> last_child;
  for (bool& last : last_child) last = draw.one_in(2);
  const auto levels = *std::max_element(column.levels.begin(), column.levels.end());
  for (std::int32_t level = 0; level < levels; ++level) {
    Leaves chosen;
    for (std::size_t place = 0; place < column.levels.size(); ++place) {
      if (column.levels[place] <= level) continue;
      PerAxis<std::int32_t> cube = column.cube;
      cube[column.axis] = static_cast<std::int32_t>(place);
      std::int32_t id = growing.tree().unit_cube(cube);
      while (!growing.tree().is_leaf(id)) {
        const auto axis = at(growing.tree().split_axis(id));
        id = growing.tree().node(id).first_child + (last_child[axis] ? growing.tree().child_count(id) - 1 : 0);
      }
      chosen.push_back(id);
    }
    make_distinct(chosen);
    if (!growing.add(Step::Kind::subdivide, chosen)) return;
  }
}

RandomCase trouble_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits, Bias bias) {
  if (bias == Bias::boxes_planar_inside) return planar_inside_case_in(draw, setting, limits);
  if (bias >= Bias::region_point) return {in_small_region(draw, setting, limits).content, bias};
  const std::int64_t cubes = std::int64_t{setting.domain[0]} * setting.domain[1] * setting.domain[2];
  // a column of few cubes needs room for some subdivisions, whatever its domain has taken, and graded meshes are long
  const std::int64_t least = bias == Bias::bare_interface ? cubes + 12 * (setting.grading - 1)
                             : bias == Bias::marks_graded ? kGradedElements
                                                          : 0;
  GrowingCase growing(setting, std::max(limits.max_elements, least));
  const int steps = draw.between(1, limits.max_steps);
  switch (bias) {
    case Bias::marks_edge:
      refine_along(draw, growing, steps, 2);
      break;
    case Bias::marks_face:
      refine_along(draw, growing, steps, 1);
      break;
    case Bias::marks_uniform:
      refine_all(growing, steps);
      break;
    case Bias::marks_graded:
      refine_graded(draw, growing);
      break;
    case Bias::bare_smaller_patch:
      subdivide_smaller_closures(draw, growing, steps);
      break;
    case Bias::bare_interface:
      subdivide_column(draw, growing, random_column(draw, setting));
      break;
    default:
      leave_holes(draw, growing, steps);
  }
  if (bias >= Bias::bare_smaller_patch) subdivide_at_least_once(growing);
  return {growing.content(), bias};
}

}  // namespace asts
