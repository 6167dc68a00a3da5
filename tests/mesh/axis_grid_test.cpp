#include "lib/mesh/axis_grid.hpp"

#include <gtest/gtest.h>

#include "lib/gen/draw.hpp"

namespace asts {
namespace {

Rational lower(const AxisGrid& grid, std::int32_t cell) {
  return grid.coordinate(grid.line_of_rank(grid.extent(cell).lower));
}
Rational upper(const AxisGrid& grid, std::int32_t cell) {
  return grid.coordinate(grid.line_of_rank(grid.extent(cell).upper));
}
Rational window_lower(const AxisGrid& grid, std::int32_t cell) {
  return grid.coordinate(grid.line_of_rank(grid.window(cell).lower));
}
Rational window_upper(const AxisGrid& grid, std::int32_t cell) {
  return grid.coordinate(grid.line_of_rank(grid.window(cell).upper));
}

TEST(AxisGrid, StartsWithTheIntegers) {
  const AxisGrid grid(5, 3, 3);
  EXPECT_EQ(grid.length(), 5);
  ASSERT_EQ(grid.line_count(), 6);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(lower(grid, grid.unit_cell(i)), i);
    EXPECT_EQ(upper(grid, grid.unit_cell(i)), i + 1);
    EXPECT_FALSE(grid.is_block(grid.unit_cell(i)));
  }
}

// The root is the whole axis; each block's two children share its units, the larger half first.
TEST(AxisGrid, BlocksHalveDownToUnitCells) {
  AxisGrid grid(5, 2, 3);
  EXPECT_TRUE(grid.is_block(grid.root()));
  EXPECT_EQ(grid.units_in(grid.root()), 5);
  const std::int32_t first = grid.children(grid.root());
  EXPECT_EQ(grid.units_in(first), 3);
  EXPECT_EQ(grid.units_in(first + 1), 2);
  EXPECT_EQ(grid.children(grid.children(first + 1)), grid.children(grid.unit_cell(3)));
  const AxisGrid single(1, 2, 3);
  EXPECT_EQ(single.root(), single.unit_cell(0));
}

// [1,2] in thirds: [1,4/3], [4/3,5/3], [5/3,2].
TEST(AxisGrid, ACellHasAsManyChildrenAsTheGradingSays) {
  AxisGrid grid(4, 3, 3);
  const std::int32_t first = grid.children(grid.unit_cell(1));
  grid.update_ranks();
  for (int j = 0; j < 3; ++j) {
    EXPECT_EQ(lower(grid, first + j), Rational(3 + j) / 3);
    EXPECT_EQ(upper(grid, first + j), Rational(4 + j) / 3);
  }
  EXPECT_EQ(grid.children(grid.unit_cell(1)), first) << "children are made once";
}

// U(K) for p = 3 reaches (p + 3/2) h from the midpoint, that is 4 h from the sides: [5,6] sees (1,10), cut off at 0
// and 12 elsewhere; the half [5,11/2] sees (3, 15/2).
TEST(AxisGrid, WindowsReachDegreePlusOneCellsBeyondTheSides) {
  AxisGrid grid(12, 2, 3);
  const std::int32_t half = grid.children(grid.unit_cell(5));
  grid.update_ranks();
  EXPECT_EQ(window_lower(grid, grid.unit_cell(5)), 1);
  EXPECT_EQ(window_upper(grid, grid.unit_cell(5)), 10);
  EXPECT_EQ(window_lower(grid, grid.unit_cell(2)), 0);
  EXPECT_EQ(window_upper(grid, grid.unit_cell(9)), 12);
  EXPECT_EQ(window_lower(grid, half), 3);
  EXPECT_EQ(window_upper(grid, half), Rational(15) / 2);
}

// Laws 1 and 2 on random splits, with windows computed again from coordinates.
TEST(AxisGrid, RanksGrowWithCoordinatesAndWindowsFollowTheirFormula) {
  Draw draw(5);
  for (int round = 0; round < 60; ++round) {
    const int length = draw.between(1, 9);
    const int grading = draw.between(2, 5);
    const int degree = 1 + 2 * draw.between(1, 3);
    AxisGrid grid(length, grading, degree);
    std::vector<std::int32_t> cells;
    for (int i = 0; i < length; ++i) cells.push_back(grid.unit_cell(i));
    for (int splits = draw.between(0, 12); splits > 0; --splits) {
      const std::int32_t first = grid.children(draw.choose(cells));
      for (int j = 0; j < grading; ++j) cells.push_back(first + j);
    }
    grid.update_ranks();
    for (std::int32_t rank = 1; rank < grid.line_count(); ++rank) {
      EXPECT_LT(grid.coordinate(grid.line_of_rank(rank - 1)), grid.coordinate(grid.line_of_rank(rank)));
      EXPECT_EQ(grid.rank_of_line(grid.line_of_rank(rank)), rank);
    }
    for (const std::int32_t cell : cells) {
      const Rational reach = (degree + 1) * (upper(grid, cell) - lower(grid, cell));
      EXPECT_EQ(window_lower(grid, cell), std::max(Rational(0), Rational(lower(grid, cell) - reach)));
      EXPECT_EQ(window_upper(grid, cell), std::min(Rational(length), Rational(upper(grid, cell) + reach)));
    }
  }
}

// Law 3: 3^-60 needs 96 bits.
TEST(AxisGrid, DepthGoesPastSixtyFourBits) {
  AxisGrid grid(3, 3, 3);
  std::int32_t cell = grid.unit_cell(1);
  Rational start = 1;
  Rational size = 1;
  for (int depth = 1; depth <= 60; ++depth) {
    cell = grid.children(cell) + 2;
    size /= 3;
    start += 2 * size;
  }
  grid.update_ranks();
  EXPECT_EQ(lower(grid, cell), start);
  EXPECT_EQ(upper(grid, cell), 2);
  EXPECT_EQ(window_lower(grid, cell), start - 4 * size);
  EXPECT_EQ(window_upper(grid, cell), 2 + 4 * size);
}

}  // namespace
}  // namespace asts
