#include "lib/zones/factor_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "lib/gen/workloads.hpp"
#include "lib/refine/replay.hpp"
#include "lib/zones/zones.hpp"

namespace asts {
namespace {

std::vector<Rational> coordinates(const AxisGrid& grid, std::span<const std::int32_t> lines) {
  std::vector<Rational> result;
  for (const std::int32_t line : lines) result.push_back(grid.coordinate(line));
  return result;
}

/// Every pair of index vectors of real meshes: the table knows what the functional says of the coordinates.
TEST(FactorTable, KnowsWhatTheFunctionalSays) {
  int zeros = 0;
  int ones = 0;
  int others = 0;
  for (const Setting& setting : {Setting{{3, 3, 5}, 2, {8, 8, 8}}, Setting{{3, 3, 3}, 3, {6, 6, 6}}}) {
    const Case content = generate_workload(Workload::random, setting, 6000);
    Replay replay(content);
    while (!replay.done()) replay.advance();
    Zones zones(replay.tree());
    zones.rebuild(1);
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const VectorStore& store = zones.stores()[at(axis)];
      const AxisGrid& grid = replay.tree().grid(axis);
      FactorTable table(setting.degree[at(axis)]);
      DualFunctional functional(setting.degree[at(axis)]);
      for (std::int32_t x = 0; x < store.size(); x += 3) {
        for (std::int32_t y = 0; y < store.size(); ++y) {
          const FieldElement value = functional.lambda(coordinates(grid, store[x]), coordinates(grid, store[y]));
          const FactorTable::Factor factor = table.of(store, x, y);
          ASSERT_TRUE(factor.known);
          EXPECT_EQ(factor.zero, value.is_zero());
          EXPECT_EQ(factor.one, value == Rational(1));
          zeros += factor.zero;
          ones += factor.one;
          others += !factor.zero && !factor.one;
        }
      }
    }
  }
  EXPECT_GT(zeros, 1000);
  EXPECT_GT(ones, 50);
  EXPECT_GT(others, 100);
}

/// Beyond 62 bits nothing is known: what was not evaluated is not called zero.
TEST(FactorTable, KnowsNothingOfNumbersThatAreTooWide) {
  AxisGrid grid(4, 2, 3);
  std::int32_t cell = grid.unit_cell(1);
  for (int depth = 0; depth < 70; ++depth) cell = grid.children(cell);
  grid.update_ranks();
  VectorStore store(3);
  std::vector<std::int32_t> lines(at(grid.line_count()));
  std::iota(lines.begin(), lines.end(), 0);
  const std::int32_t deep = *std::max_element(
      lines.begin(), lines.end(), [&](auto one, auto other) { return grid.line_depth(one) < grid.line_depth(other); });
  ASSERT_GT(grid.line_depth(deep), 62);
  std::vector<std::int32_t> wide{0, 1, 2, 3, deep};
  std::sort(wide.begin(), wide.end(),
            [&](auto one, auto other) { return grid.rank_of_line(one) < grid.rank_of_line(other); });
  const std::vector<std::int32_t> narrow{0, 1, 2, 3, 4};
  const std::int32_t x = store.intern(grid, wide);
  const std::int32_t y = store.intern(grid, narrow);
  FactorTable table(3);
  EXPECT_FALSE(table.of(store, x, y).known);
  EXPECT_FALSE(table.of(store, y, x).known);
  EXPECT_FALSE(table.of(store, x, x).one);
  EXPECT_TRUE(table.of(store, y, y).one);
}

}  // namespace
}  // namespace asts
