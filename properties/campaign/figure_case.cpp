#include "lib/gen/growing_case.hpp"
#include "properties/campaign/provoked_cases.hpp"
#include "properties/claims/proof_figure.hpp"

namespace asts {

namespace {

constexpr std::array<int, 2> kFigureSquares{17, 21};
constexpr int kMostSide = 9;

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
Case figure_case(Draw& draw) {
  const ProofFigure figure = drawn_proof_figure();
  const FigurePlace place{draw.between(0, 2), 0};
  Case result{{}, 2, {}, {}, false, {}};
  for (int& degree : result.degree) degree = 1 + 2 * draw.between(1, 3);
  const int frame = (result.degree[0] + 1) / 2;
  const int layers = 2 * frame + draw.between(1, kMostSide - 2 * frame);
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
