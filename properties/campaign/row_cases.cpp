#include "properties/campaign/provoked_cases.hpp"

namespace asts {

Case random_row(Draw& draw, int m, int most_length, int least_length, int breadth) {
  Case row{{3, 1 + 2 * draw.between(1, 3), 1 + 2 * draw.between(1, 3)}, m, {}, {}, false, {}};
  row.domain = {draw.between(least_length, most_length), 1, 1};
  row.domain[1 + draw.index(2)] = draw.between(1, breadth);
  return row;
}

Point row_point(const Case& row, bool mirrored, const Rational& x) {
  return {CompactRational(mirrored ? Rational(row.domain[0] - x) : x), CompactRational(), CompactRational()};
}

void refine_at(Case& row, const Point& point) { row.steps.push_back({Step::Kind::refine, {point}}); }

void mark_towards_neighbour(Case& row, bool mirrored, int cube, int depth) {
  const Rational place = cube + (Rational(row.grading - 4 * depth) + Rational(1) / 2) / row.grading;
  for (int step = 0; step < depth; ++step) refine_at(row, row_point(row, mirrored, place));
}

// Half of the marks stand where the closure of the last one just reaches the neighbour, the others nearer to the end.
Case row_case(Draw& draw, int m) {
  constexpr int kMostLength = 4;
  Case row = random_row(draw, m, kMostLength, 2, 1);
  const bool mirrored = draw.one_in(2);
  const int cube = draw.between(0, row.domain[0] - 2);
  const int depth = draw.between(1, 3);
  if (draw.one_in(2)) {
    mark_towards_neighbour(row, mirrored, cube, depth);
  } else {
    const Rational place = cube + (Rational(m - draw.between(1, 4 * depth)) + Rational(1) / 2) / m;
    for (int step = 0; step < depth; ++step) refine_at(row, row_point(row, mirrored, place));
  }
  return row;
}

// A mark is any point of the corner's element, whose sides are m^(-l/3) and so on for the level l that it has by then.
Case corner_case(Draw& draw, int m, const std::array<int, 2>& steps_between) {
  constexpr int kSide = 5;
  Case result{{3, 3, 3}, m, {kSide, kSide, kSide}, {}, false, {}};
  PerAxis<bool> high;
  for (bool& axis : high) axis = draw.one_in(2);
  PerAxis<Rational> size{1, 1, 1};
  const int steps = draw.between(steps_between[0], steps_between[1]);
  for (int step = 0; step < steps; ++step) {
    Step mark{Step::Kind::refine, {}};
    for (int points = draw.one_in(8) ? 2 : 1; points > 0; --points) {
      Point point;
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        const Rational from_side = draw.one_in(2) ? Rational(0) : Rational(size[axis] * draw.between(1, 4) / 5);
        point[axis] = CompactRational(high[axis] ? Rational(kSide - from_side) : from_side);
      }
      mark.marks.push_back(point);
    }
    result.steps.push_back(mark);
    size[static_cast<std::size_t>(step % kDimension)] /= m;
  }
  return result;
}

}  // namespace asts
