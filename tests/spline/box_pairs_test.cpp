#include "lib/spline/box_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "lib/gen/draw.hpp"

namespace asts {
namespace {

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// What the search reports, each pair with its smaller index first, sorted; repetitions stay.
Pairs self_pairs(const std::vector<Box>& boxes) {
  Pairs pairs;
  for_each_meeting_pair(boxes, [&](std::int32_t i, std::int32_t j) { pairs.emplace_back(std::minmax(i, j)); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs cross_pairs(const std::vector<Box>& one, const std::vector<Box>& other) {
  Pairs pairs;
  for_each_meeting_pair(one, other, [&](std::int32_t i, std::int32_t j) { pairs.emplace_back(i, j); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool meet(const Box& a, const Box& b) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (a.upper[axis] < b.lower[axis] || b.upper[axis] < a.lower[axis]) return false;
  }
  return true;
}

// A face, an edge, a corner in common count; one step apart does not.
TEST(BoxPairs, TouchingCounts) {
  const Box cube{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(self_pairs({cube, {{1, 0, 0}, {2, 1, 1}}}), (Pairs{{0, 1}}));
  EXPECT_EQ(self_pairs({cube, {{1, 1, 0}, {2, 2, 1}}}), (Pairs{{0, 1}}));
  EXPECT_EQ(self_pairs({cube, {{1, 1, 1}, {2, 2, 2}}}), (Pairs{{0, 1}}));
  EXPECT_EQ(self_pairs({cube, {{2, 1, 1}, {3, 2, 2}}}), Pairs{});
}

// Rectangles without extent along an axis, and points: the slices of perturbed regions are such.
TEST(BoxPairs, FlatBoxesAreBoxes) {
  const Box flat{{2, 0, 0}, {2, 4, 4}};
  const Box point{{2, 4, 4}, {2, 4, 4}};
  EXPECT_EQ(self_pairs({flat, point, flat}), (Pairs{{0, 1}, {0, 2}, {1, 2}}));
  EXPECT_EQ(cross_pairs({flat}, {point, {{3, 0, 0}, {3, 4, 4}}}), (Pairs{{0, 0}}));
}

TEST(BoxPairs, NoPairsOfEmptyLists) {
  EXPECT_EQ(self_pairs({}), Pairs{});
  EXPECT_EQ(self_pairs({{{0, 0, 0}, {1, 1, 1}}}), Pairs{}) << "no box meets itself";
  EXPECT_EQ(cross_pairs({}, {{{0, 0, 0}, {1, 1, 1}}}), Pairs{});
}

std::vector<Box> random_boxes(Draw& draw, int count, int range) {
  std::vector<Box> boxes;
  for (; count > 0; --count) {
    Box box{};
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      box.lower[axis] = draw.between(-range, range);
      box.upper[axis] = box.lower[axis] + draw.between(0, 4);
    }
    boxes.push_back(draw.one_in(8) && !boxes.empty() ? draw.choose(boxes) : box);  // equal boxes are a pair too
  }
  return boxes;
}

// CGAL compares all with all below 10 boxes and searches in another way above: counts on both sides of that, crowded
// and sparse. Comparing sorted lists finds pairs that come twice.
TEST(BoxPairs, EveryPairOnceAgainstAllWithAll) {
  Draw draw(20);
  for (const int count : {2, 5, 9, 10, 11, 12, 40, 150, 400}) {
    for (const int range : {2, 6, 30}) {
      const std::vector<Box> one = random_boxes(draw, count, range);
      const std::vector<Box> other = random_boxes(draw, draw.between(1, 2 * count), range);
      Pairs expected_self;
      Pairs expected_cross;
      for (std::int32_t i = 0; i < count; ++i) {
        const Box& box = one[static_cast<std::size_t>(i)];
        for (std::int32_t j = i + 1; j < count; ++j) {
          if (meet(box, one[static_cast<std::size_t>(j)])) expected_self.emplace_back(i, j);
        }
        for (std::int32_t j = 0; j < static_cast<std::int32_t>(other.size()); ++j) {
          if (meet(box, other[static_cast<std::size_t>(j)])) expected_cross.emplace_back(i, j);
        }
      }
      EXPECT_EQ(self_pairs(one), expected_self) << count << " boxes within " << range;
      EXPECT_EQ(cross_pairs(one, other), expected_cross) << count << " boxes within " << range;
    }
  }
}

}  // namespace
}  // namespace asts
