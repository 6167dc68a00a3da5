#include <algorithm>
#include <optional>

#include "lib/gen/growing_case.hpp"
#include "lib/gen/planar_tiling.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/refine/replay.hpp"
#include "properties/claims/proof_figure.hpp"
#include "tests/minimize/special_starts.hpp"
#include "tests/minimize/start_meshes.hpp"

namespace asts {

namespace {

constexpr std::array<int, 2> kFigureSquares{17, 21};

/// The degrees of a planar mesh and the unit squares in its active region, so that no side is longer than 9.
struct PlanarSetting {
  PerAxis<int> degree;
  std::array<int, 2> squares;
};

PlanarSetting planar_setting(Draw& draw) {
  PlanarSetting setting;
  for (int& degree : setting.degree) degree = draw.one_in(2) ? 3 : 1 + 2 * draw.between(1, 3);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    setting.squares[axis] = draw.between(1, kLargestStartSide - setting.degree[axis] - 1);
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

Case planar_boxes(Draw& draw) {
  const PlanarSetting setting = planar_setting(draw);
  Case result = turned(draw, random_planar_tiling(draw, setting.squares).extruded(setting.degree));
  result.grading = draw.between(2, 4);
  return result;
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

Case planar_steps(Draw& draw) {
  const PlanarSetting setting = planar_setting(draw);
  SteppedPlane plane(draw, setting);
  const int squares = setting.squares[0] * setting.squares[1];
  for (int cuts = draw.between(2, 3 + 2 * squares); cuts > 0; --cuts) plane.cut_somewhere();
  return plane.content();
}

namespace {

/// The figure's place in a domain.
struct FigurePlace {
  int margin;
  Rational middle;  ///< of K, along x
};

Point in_figure(Draw& draw, const FigurePlace& place, const std::array<int, 2>& halves) {
  Point point{CompactRational(place.middle + Rational(draw.between(-2, 2)) / 9), {}, {}};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Rational low = Rational(halves[axis]) / 2 + place.margin;
    point[axis + 1] = CompactRational(low + Rational(draw.between(0, 3)) / 8);
  }
  return point;
}

/// One mark for each element of a level on the slice in a rectangle, in random order, as some steps.
void add_level(Draw& draw, const ProofFigure::Rectangle& region, int level, const FigurePlace& place, Case& figure) {
  std::vector<Point> marks;
  const int y_step = level >= 2 ? 1 : 2;
  for (int y = region.lower[0]; y < region.upper[0]; y += y_step) {
    for (int z = region.lower[1]; z < region.upper[1]; z += 2) marks.push_back(in_figure(draw, place, {y, z}));
  }
  draw.shuffle(marks);
  const std::size_t parts = draw.index(3) + 1;
  for (std::size_t part = 0; part < parts; ++part) {
    const auto end = [&](std::size_t number) {
      return marks.begin() + static_cast<std::ptrdiff_t>(marks.size() * number / parts);
    };
    figure.steps.push_back({Step::Kind::subdivide, {end(part), end(part + 1)}});
  }
}

/// Up to some subdivisions in the other half of K's layer of cubes and in other layers.
void add_beside_slice(Draw& draw, const FigurePlace& place, Case& figure) {
  for (int steps = draw.between(0, 3); steps > 0; --steps) {
    Step step{Step::Kind::subdivide, {}};
    for (int marks = draw.between(1, 6); marks > 0; --marks) {
      Point point = random_point(draw, setting_of(figure));
      const Rational distance = abs(Rational(point[0].value() - place.middle));
      if (distance > Rational(3) / 4 || figure.domain[0] == 1) step.marks.push_back(point);
    }
    if (!step.marks.empty() && figure.domain[0] > 1) figure.steps.push_back(step);
  }
}

}  // namespace

// What the claim's own eye for the figure leaves open: p, the width of the frame, the number of layers along x, where K
// lies among those of the active region, and all elements that the slice does not meet.
Case figure_start(Draw& draw) {
  const ProofFigure figure = drawn_proof_figure();
  const FigurePlace place{draw.between(0, 2), 0};
  Case result{{}, 2, {}, {}, false, {}};
  for (int& degree : result.degree) degree = 1 + 2 * draw.between(1, 3);
  const int frame = (result.degree[0] + 1) / 2;
  const int layers = 2 * frame + draw.between(1, 9 - 2 * frame);
  result.domain = {layers, kFigureSquares[0] + 2 * place.margin, kFigureSquares[1] + 2 * place.margin};
  const int half = draw.between(2 * frame, 2 * (layers - frame) - 1);
  const FigurePlace placed{place.margin, (Rational(half) + Rational(1) / 2) / 2};
  for (int level = 0; level < 3; ++level) {
    add_level(draw, figure.levels[static_cast<std::size_t>(level)], level, placed, result);
  }
  add_beside_slice(draw, placed, result);
  result.steps.push_back({Step::Kind::subdivide, {in_figure(draw, placed, figure.element.lower)}});
  return result;
}

}  // namespace asts
