#include <algorithm>

#include "properties/campaign/provoked_cases.hpp"
#include "tests/minimize/special_starts.hpp"
#include "tests/minimize/start_meshes.hpp"

namespace asts {

namespace {

constexpr std::int64_t kMostDistanceSubdivisions = 13;

/// Anywhere in a unit cube but on its sides.
Point inside_cube(Draw& draw, const PerAxis<int>& cube) {
  Point point;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    point[axis] = CompactRational(Rational(cube[axis]) + Rational(draw.between(1, 6)) / 7);
  }
  return point;
}

void insert_step(Draw& draw, Case& test_case, const Step& step, std::size_t first) {
  const std::size_t place = first + draw.index(test_case.steps.size() - first + 1);
  test_case.steps.insert(test_case.steps.begin() + static_cast<std::ptrdiff_t>(place), step);
}

}  // namespace

// The closure of a mark leads from level to level, three slabs of width 1/m onwards each time, out of the cube into its
// neighbour. From one subdivision on the last child of that is too far for m >= 1315; a mark of level 2 does it for m
// from 1300 on, one of level 3 from 1285 on.
Case distance_start(Draw& draw) {
  const int m = draw.between(1285, 1400);
  const int depth = m >= 1315 ? draw.between(1, 3) : m >= 1300 ? draw.between(2, 3) : 3;
  Case row = random_row(draw, m, kLargestStartSide, depth == 3 ? 2 : 4, depth == 3 ? 1 : 3);
  if (depth < 3) row.domain[0] = kLargestStartSide;
  const bool mirrored = draw.one_in(2);
  const int cube = draw.between(0, row.domain[0] - 2);
  mark_towards_neighbour(row, mirrored, cube, depth);
  const std::int64_t size = draw.between(kLeastStartSize, kMostDistanceSubdivisions);
  while (size_of(row) < size) {
    PerAxis<int> other{draw.between(0, row.domain[0] - 1), draw.between(0, row.domain[1] - 1),
                       draw.between(0, row.domain[2] - 1)};
    const int from_end = mirrored ? row.domain[0] - 1 - other[0] : other[0];
    if (from_end == cube || from_end == cube + 1) {
      if (row.domain[0] == 2) break;
      continue;
    }
    insert_step(draw, row, {Step::Kind::refine, {inside_cube(draw, other)}}, 0);
  }
  return row;
}

// The chain of reports/findings/lambda-sums.md, from the cube `start` through the next one into the third: 1302 or
// fewer marks of level 4 are within reach of its last child. Marks of level 0 in cubes before the chain's first and in
// those three beyond its last are out of reach, and so are more marks of the chain before the first that is needed.
Case chain_start(Draw& draw) {
  const int m = draw.between(1303, 1331);
  Case row = random_row(draw, m, kLargestStartSide, 3, 1);
  row.domain[1] = row.domain[2] = 1;
  const bool mirrored = draw.one_in(2);
  const int start = draw.between(0, row.domain[0] - 3);
  // for m = 1303 the first slab is 1291, for m = 1331 it is 1329: see marks_within_reach in the claim's own tests
  const int first = 1291 - draw.between(0, 20);
  const auto at_slab = [&](const Rational& slab) { return row_point(row, mirrored, start + slab / m); };
  const Rational half = Rational(1) / 2;
  refine_at(row, at_slab(half));
  for (int level = 1; level <= 3; ++level) refine_at(row, at_slab(first + half));
  for (int slab = first; slab <= 2 * m - 13; ++slab) refine_at(row, at_slab(slab + 1 - half / m));
  for (int cube = 0; cube < row.domain[0]; ++cube) {
    const int from_end = mirrored ? row.domain[0] - 1 - cube : cube;
    const bool out_of_reach = from_end < start - 1 || from_end > start + 5;
    if (!out_of_reach || draw.one_in(3)) continue;
    insert_step(draw, row, {Step::Kind::refine, {inside_cube(draw, {cube, 0, 0})}}, 0);
  }
  return row;
}

Case corner_start(Draw& draw) { return corner_case(draw, 3, {117, 125}); }

}  // namespace asts
