#include <algorithm>
#include <optional>

#include "lib/gen/planar_tiling.hpp"
#include "lib/mesh/refinement_tree.hpp"
#include "properties/campaign/provoked_cases.hpp"

namespace asts {

namespace {

constexpr int kMostSide = 9;

/// The degrees of a planar mesh and the unit squares in its active region, so that no side is longer than 9.
struct PlanarSetting {
  PerAxis<int> degree;
  std::array<int, 2> squares;
};

PlanarSetting planar_setting(Draw& draw) {
  PlanarSetting setting;
  for (int& degree : setting.degree) degree = draw.one_in(2) ? 3 : 1 + 2 * draw.between(1, 3);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    setting.squares[axis] = draw.between(1, kMostSide - setting.degree[axis] - 1);
  }
  return setting;
}

/// The axes in another order.
Case turned(Draw& draw, const Case& boxes) {
  std::vector<std::size_t> order{0, 1, 2};
  draw.shuffle(order);
  Case result = boxes;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    result.degree[axis] = boxes.degree[order[axis]];
    result.domain[axis] = boxes.domain[order[axis]];
    for (std::size_t i = 0; i < boxes.elements.size(); ++i) {
      result.elements[i].lower[axis] = boxes.elements[i].lower[order[axis]];
      result.elements[i].upper[axis] = boxes.elements[i].upper[order[axis]];
    }
  }
  draw.shuffle(result.elements);
  return result;
}

/// A place among some number of equal parts of the unit interval.
Rational random_part(Draw& draw, int m) { return (Rational(draw.between(0, m - 1)) + Rational(1) / 2) / m; }

}  // namespace

Case planar_case_of_boxes(Draw& draw) {
  const PlanarSetting setting = planar_setting(draw);
  Case result = turned(draw, random_planar_tiling(draw, setting.squares).extruded(setting.degree));
  result.grading = draw.between(2, 4);
  return result;
}

Case small_planar_case_of_boxes(Draw& draw) {
  PerAxis<int> degree{3, 3, 3};
  if (draw.one_in(4)) degree[draw.index(kDimension)] = 5;
  const std::array<int, 2> squares{draw.between(2, 3), draw.between(2, 3)};
  return turned(draw, random_planar_tiling(draw, squares).extruded(degree));
}

namespace {

/// A planar mesh that steps make. Each subdivides whatever elements are at one or more points (x, y), in each layer of
/// unit cubes.
class SteppedPlane {
 public:
  SteppedPlane(Draw& draw, const PlanarSetting& setting)
      : draw_(draw), setting_(setting), case_{setting.degree, draw.between(2, 4), {}, {}, false, {}} {
    for (std::size_t axis = 0; axis < 2; ++axis) case_.domain[axis] = setting.squares[axis] + setting.degree[axis] + 1;
    case_.domain[2] = setting.degree[2] + 1;
    tree_.emplace(setting_of(case_));
  }

  const Case& content() const { return case_; }

  /// In a random square of the active region: along x first, then along y; elements of level 2 stay. Lines that end on
  /// the region's sides run on to the domain's.
  void cut_somewhere() {
    PerAxis<int> cube{};
    for (std::size_t axis = 0; axis < 2; ++axis)
      cube[axis] = frame(axis) + draw_.between(0, setting_.squares[axis] - 1);
    const Rational x = cube[0] + random_part(draw_, case_.grading);
    const Rational y = cube[1] + random_part(draw_, case_.grading);
    const std::int32_t level = level_at(x, y);
    if (level >= 2) return;
    step_ = {Step::Kind::subdivide, {}};
    add_column(x, y);
    for (int row = 0; level == 0 && row < frame(1); ++row) {
      if (cube[1] == frame(1)) add_column(x, row + random_part(draw_, 2));
      if (cube[1] == case_.domain[1] - frame(1) - 1) add_column(x, case_.domain[1] - 1 - row + random_part(draw_, 2));
    }
    for (const Point& mark : step_.marks) tree_->subdivide(tree_->leaf_at(mark));
    tree_->update_ranks();
    draw_.shuffle(step_.marks);
    case_.steps.push_back(step_);
  }

 private:
  int frame(std::size_t axis) const { return (case_.degree[axis] + 1) / 2; }

  std::int32_t level_at(const Rational& x, const Rational& y) const {
    return tree_->node(tree_->leaf_at({CompactRational(x), CompactRational(y), CompactRational()})).level;
  }

  void add_column(const Rational& x, const Rational& y) {
    for (int layer = 0; layer < case_.domain[2]; ++layer) {
      const Rational z = layer + random_part(draw_, case_.grading);
      step_.marks.push_back({CompactRational(x), CompactRational(y), CompactRational(z)});
    }
  }

  Draw& draw_;
  PlanarSetting setting_;
  Case case_;
  std::optional<RefinementTree> tree_;
  Step step_;
};

}  // namespace

Case planar_case_of_steps(Draw& draw) {
  const PlanarSetting setting = planar_setting(draw);
  SteppedPlane plane(draw, setting);
  const int squares = setting.squares[0] * setting.squares[1];
  for (int cuts = draw.between(2, 3 + 2 * squares); cuts > 0; --cuts) plane.cut_somewhere();
  return plane.content();
}

}  // namespace asts
