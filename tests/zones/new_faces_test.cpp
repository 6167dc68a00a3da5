#include "lib/zones/new_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "lib/gen/workloads.hpp"
#include "lib/refine/replay.hpp"
#include "lib/zones/rank_box.hpp"

namespace asts {
namespace {

using Ranks = std::vector<std::int32_t>;

TEST(InsertEntries, TakesTheNearestOnEitherSide) {
  Ranks result;
  insert_entries(Ranks{10, 20, 30, 40, 50}, Ranks{25}, result);
  EXPECT_EQ(result, (Ranks{20, 25, 30, 40, 50}));
  insert_entries(Ranks{10, 20, 30, 40, 50}, Ranks{12, 15, 35, 35, 38, 45}, result);
  EXPECT_EQ(result, (Ranks{15, 20, 30, 35, 38}));
  insert_entries(Ranks{10, 20, 30, 40, 50}, Ranks{5, 10, 20, 30, 40, 55}, result);
  EXPECT_EQ(result, (Ranks{10, 20, 30, 40, 50})) << "entries that are known, or too far away";
  insert_entries(Ranks{10, 20, 30, 40, 50}, {}, result);
  EXPECT_EQ(result, (Ranks{10, 20, 30, 40, 50}));
}

/// Definition 4.4 from the line's entries: the middle one and `reach` on either side.
Ranks vector_around(const std::set<std::int32_t>& line, std::int32_t middle, int reach) {
  const auto own = line.find(middle);
  return {std::prev(own, reach), std::next(own, reach + 1)};
}

TEST(InsertEntries, GivesTheVectorOfTheLineWithAllItsEntries) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 20'000; ++round) {
    const int reach = 2 + static_cast<int>(random() % 3);
    std::set<std::int32_t> line;
    while (line.size() < 12) line.insert(static_cast<std::int32_t>(random() % 40));
    const std::int32_t middle = *std::next(line.begin(), reach + static_cast<int>(random() % (12 - 2 * reach)));
    const Ranks old = vector_around(line, middle, reach);
    Ranks added(random() % 8);
    for (std::int32_t& entry : added) entry = static_cast<std::int32_t>(random() % 40);
    std::sort(added.begin(), added.end());
    line.insert(added.begin(), added.end());
    Ranks result;
    insert_entries(old, added, result);
    ASSERT_EQ(result, vector_around(line, middle, reach))
        << ::testing::PrintToString(old) << " with " << ::testing::PrintToString(added);
  }
}

/// Every line through some ranks, and the new faces of the last step that it crosses.
void compare(const Setting& setting) {
  const Case content = generate_workload(Workload::sphere, setting, 3000);
  Replay replay(content);
  while (!replay.done()) replay.advance();
  const RefinementTree& tree = replay.tree();
  NewFaces faces;
  std::size_t crossings = 0;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const Axis one = axis_after(axis);
    const Axis other = axis_after(one);
    Ranks split;
    for (const std::int32_t element : replay.subdivided()) {
      if (tree.split_axis(element) == axis) split.push_back(element);
    }
    Ranks rows;
    Ranks columns;
    for (std::int32_t i = 3; i < tree.grid(one).line_count() - 1; i += 2) rows.push_back(i);
    for (std::int32_t i = 1; i < tree.grid(other).line_count(); i += 3) columns.push_back(i);
    faces.assign(tree, axis, split, rows, columns);
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (std::size_t column = 0; column < columns.size(); ++column) {
        Ranks expected;
        for (const std::int32_t element : split) {
          const RankBox box = box_of(tree, element);
          if (rows[row] < box[one].lower || rows[row] > box[one].upper) continue;
          if (columns[column] < box[other].lower || columns[column] > box[other].upper) continue;
          for (std::int32_t child = 1; child < setting.grading; ++child) {
            expected.push_back(tree.extent(tree.first_child(element) + child, axis).lower);
          }
        }
        std::sort(expected.begin(), expected.end());
        const auto found = faces.on(row, column);
        ASSERT_EQ(Ranks(found.begin(), found.end()), expected);
        crossings += expected.size();
      }
    }
  }
  EXPECT_GT(crossings, 100U);
}

TEST(NewFaces, AreThoseThatALineCrosses) {
  compare({{3, 3, 3}, 2, {8, 8, 8}});
  compare({{3, 5, 3}, 3, {7, 9, 8}});
}

}  // namespace
}  // namespace asts
