#include "lib/exact/grid_coordinate.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <limits>
#include <unordered_set>

#include "lib/exact/errors.hpp"

namespace asts {
namespace {

constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kMin = std::numeric_limits<std::int64_t>::min();

/// index/m^depth by GMP alone.
Rational value(int m, const Integer& index, int depth) {
  return Rational(index) / Rational(Integer(boost::multiprecision::pow(Integer(m), static_cast<unsigned>(depth))));
}

/// Indices of every size, and more often near the ends of 64 bits than anywhere else.
Integer any_index() {
  const std::int64_t base = *rc::gen::weightedOneOf<std::int64_t>(
      {{2, rc::gen::arbitrary<std::int64_t>()}, {1, rc::gen::just(kMax)}, {1, rc::gen::just(kMin)}});
  const Integer factor = *rc::gen::weightedElement<int>({{4, 1}, {1, 6}, {1, 1'000'000}});
  return base * factor + *rc::gen::inRange(-3, 4);
}

GridCoordinate any_coordinate(int m) { return {m, any_index(), *rc::gen::inRange(0, 50)}; }

int any_grading() { return *rc::gen::element(2, 3, 4, 6, 10, 1'000'000); }

TEST(GridCoordinate, ValuesByHand) {
  const GridCoordinate half(2, 1, 1);
  EXPECT_EQ(to_string(half.to_rational()), "1/2");
  EXPECT_EQ(to_string(half.refined(1).to_rational()), "3/4");
  EXPECT_EQ(to_string(GridCoordinate(3, 5, 0).refined(2).to_rational()), "17/3");  // 5 + 2/3
  EXPECT_EQ(to_string(GridCoordinate(3, 5, 1).translated(-7).to_rational()), "-2/3");
  EXPECT_EQ(GridCoordinate(4, 8, 2).canonical().depth(), 1) << "8/16 = 2/4, and 4 does not divide 2";
  EXPECT_LT(half, GridCoordinate(2, 3, 2));
  EXPECT_EQ(half, GridCoordinate(2, 1 << 20, 21));
}

RC_GTEST_PROP(GridCoordinate, Law1Value, ()) {
  const int m = any_grading();
  const Integer index = any_index();
  const int depth = *rc::gen::inRange(0, 50);
  RC_ASSERT(GridCoordinate(m, index, depth).to_rational() == value(m, index, depth));
  RC_ASSERT(GridCoordinate(m, index, depth).index() == index);
}

RC_GTEST_PROP(GridCoordinate, Law2Refinement, ()) {
  const int m = any_grading();
  const GridCoordinate c = any_coordinate(m);
  const int j = *rc::gen::inRange(0, m + 1);
  RC_ASSERT(c.refined(j).to_rational() == c.to_rational() + value(m, j, c.depth() + 1));
  RC_ASSERT(c.refined(j).depth() == c.depth() + 1);
  RC_ASSERT(c.refined(0) == c);
  RC_ASSERT(c.refined(m) == c.translated(1));
}

RC_GTEST_PROP(GridCoordinate, Law3Translation, (std::int64_t a)) {
  const int m = any_grading();
  const GridCoordinate c = any_coordinate(m);
  const std::int64_t b = *rc::gen::inRange<std::int64_t>(-1000, 1000);
  RC_ASSERT(c.translated(a).to_rational() == c.to_rational() + value(m, a, c.depth()));
  RC_ASSERT(c.translated(a / 2).translated(b) == c.translated(a / 2 + b));
}

RC_GTEST_PROP(GridCoordinate, Law4OrderIsThatOfTheValues, ()) {
  const int m = any_grading();
  const GridCoordinate a = any_coordinate(m);
  const int deeper = *rc::gen::inRange(0, 40);
  // Random pairs are hardly ever close: the second one is often the first on another grid, moved by a step or none.
  const bool near = *rc::gen::arbitrary<bool>();
  const GridCoordinate b =
      near ? a.at_depth(a.depth() + deeper).translated(*rc::gen::inRange(-1, 2)) : any_coordinate(m);
  const int expected = a.to_rational().compare(b.to_rational());
  RC_ASSERT((a <=> b) == (expected <=> 0));
  RC_ASSERT((b <=> a) == (0 <=> expected));
  RC_ASSERT((a == b) == (expected == 0));
}

RC_GTEST_PROP(GridCoordinate, Law5CanonicalForm, ()) {
  const int m = any_grading();
  const GridCoordinate c = any_coordinate(m);
  const GridCoordinate low = c.canonical();
  RC_ASSERT(low == c);
  RC_ASSERT(low.depth() == 0 || low.index() % m != 0);
  RC_ASSERT(c.at_depth(c.depth() + 30).canonical().depth() == low.depth());
  RC_ASSERT(c.at_depth(c.depth() + 30).canonical().index() == low.index());
}

RC_GTEST_PROP(GridCoordinate, Law6EqualCoordinatesHaveEqualHashes, ()) {
  const GridCoordinate c = any_coordinate(any_grading());
  const std::hash<GridCoordinate> hash;
  RC_ASSERT(hash(c) == hash(c.at_depth(c.depth() + *rc::gen::inRange(0, 40))));
}

TEST(GridCoordinate, Law6HashesTellGridPointsApart) {
  std::unordered_set<std::size_t> hashes;
  for (int i = 0; i < 4096; ++i) hashes.insert(std::hash<GridCoordinate>()(GridCoordinate(2, i, 10)));
  EXPECT_GT(hashes.size(), 4000U);
}

TEST(GridCoordinate, Law7CrossesTheBorderByRefinement) {
  // m = 3 on an axis of length 5: 5*3^38 < 2^63 < 5*3^39, so depth 44 is well behind the border.
  GridCoordinate corner(3, 5, 0);
  GridCoordinate mixed(3, 4, 0);
  Integer corner_index = 5, mixed_index = 4;
  for (int depth = 1; depth <= 60; ++depth) {
    corner = corner.refined(0);
    mixed = mixed.refined(depth % 3);
    corner_index = corner_index * 3;
    mixed_index = mixed_index * 3 + depth % 3;
    ASSERT_EQ(corner.index(), corner_index) << depth;
    ASSERT_EQ(mixed.index(), mixed_index) << depth;
    ASSERT_EQ(corner.is_small(), corner_index <= kMax) << depth;
    ASSERT_EQ(corner.to_rational(), 5) << depth;
    ASSERT_LT(mixed, corner) << depth;
    ASSERT_EQ(corner, GridCoordinate(3, 5, 0)) << depth;
    ASSERT_LT(corner.translated(-1), GridCoordinate(3, 5, 0)) << depth;
  }
  EXPECT_FALSE(GridCoordinate(3, 5, 0).at_depth(44).is_small());
  EXPECT_TRUE(corner.canonical().is_small());
}

TEST(GridCoordinate, Law7CrossesTheBorderByOneStep) {
  const GridCoordinate last(2, kMax, 7), first(2, kMin, 7);
  EXPECT_EQ(last.translated(1).index(), Integer(kMax) + 1);
  EXPECT_EQ(first.translated(-1).index(), Integer(kMin) - 1);
  EXPECT_FALSE(last.translated(1).is_small());
  EXPECT_TRUE(last.translated(1).translated(-1).is_small()) << "comes back into 64 bits";
  EXPECT_LT(last, last.translated(1));
  EXPECT_EQ(GridCoordinate(2, (kMax - 1) / 2, 0).refined(1).index(), kMax);
  EXPECT_TRUE(GridCoordinate(2, (kMax - 1) / 2, 0).refined(1).is_small());
  EXPECT_FALSE(GridCoordinate(2, (kMax - 1) / 2, 0).refined(2).is_small());
}

TEST(GridCoordinate, RefusesWhatIsNoGrid) {
  EXPECT_THROW(GridCoordinate(1, 0, 0), InputError);
  EXPECT_THROW(GridCoordinate(2, 0, -1), InputError);
  EXPECT_THROW(GridCoordinate(2, 0, 0).refined(-1), InputError);
  EXPECT_THROW(GridCoordinate(2, 0, 0).refined(3), InputError);
  EXPECT_THROW(GridCoordinate(2, 0, 3).at_depth(2), InputError);
  EXPECT_THROW((void)(GridCoordinate(2, 0, 0) == GridCoordinate(3, 0, 0)), InputError);
  EXPECT_THROW(GridCoordinate(2, 1, std::numeric_limits<int>::max()).refined(0), ResourceError);
}

}  // namespace
}  // namespace asts
