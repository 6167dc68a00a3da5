#include "lib/spline/index_vectors.hpp"

#include <gtest/gtest.h>

#include <map>

#include "lib/gen/draw.hpp"
#include "tests/reference/suitability.hpp"

namespace asts {
namespace {

using Vector = std::vector<std::int32_t>;

Vector missing(const Vector& one, const Vector& other) {
  Vector result;
  append_missing(one, other, result);
  return result;
}

TEST(IndexVectors, EqualVectorsHaveOneIdentifier) {
  IndexVectors vectors(3);
  EXPECT_EQ(vectors.length(), 5U);
  EXPECT_EQ(vectors.size(), 0);
  const Vector first{0, 1, 2, 3, 4};
  const Vector second{0, 1, 2, 3, 5};
  const std::int32_t id = vectors.intern(first);
  EXPECT_NE(vectors.intern(second), id);
  EXPECT_EQ(vectors.intern(first), id);
  EXPECT_EQ(vectors.size(), 2);
  EXPECT_TRUE(std::equal(first.begin(), first.end(), vectors[id].begin(), vectors[id].end()));
  EXPECT_EQ(vectors.front(id), 0);
  EXPECT_EQ(vectors.back(id), 4);
}

// Many more vectors than the table begins with.
TEST(IndexVectors, IdentifiersStayWhileTheTableGrows) {
  Draw draw(18);
  IndexVectors vectors(5);
  std::map<Vector, std::int32_t> known;
  for (int round = 0; round < 5000; ++round) {
    Vector vector{draw.between(0, 3)};
    while (vector.size() < 7) vector.push_back(vector.back() + draw.between(1, 4));
    const auto [entry, is_new] = known.emplace(vector, vectors.size());
    EXPECT_EQ(vectors.intern(vector), entry->second) << is_new;
  }
  EXPECT_EQ(static_cast<std::size_t>(vectors.size()), known.size());
  EXPECT_GT(known.size(), 2000U);
  for (const auto& [vector, id] : known) {
    EXPECT_TRUE(std::equal(vector.begin(), vector.end(), vectors[id].begin(), vectors[id].end()));
  }
}

// Condition (6.1), with closed ranges.
TEST(Overlap, ByHand) {
  const Vector even{0, 2, 4, 6, 8};
  EXPECT_TRUE(overlap(even, even));
  EXPECT_TRUE(overlap(even, Vector{4, 6, 8, 10, 12})) << "consecutive entries of one index set";
  EXPECT_TRUE(overlap(even, Vector{8, 9, 10, 11, 12})) << "the common entry 8 is in both";
  EXPECT_TRUE(overlap(even, Vector{9, 10, 11, 12, 13})) << "nothing in common";
  EXPECT_FALSE(overlap(even, Vector{4, 5, 6, 8, 10})) << "5 is within [0,8] and no entry";
  EXPECT_FALSE(overlap(even, Vector{4, 8, 10, 12, 14})) << "6 is within [4,14] and no entry";
  EXPECT_FALSE(overlap(even, Vector{-1, 0, 8, 9, 10})) << "2, 4 and 6 are lacking";
  EXPECT_FALSE(overlap(even, Vector{-1, 1, 9, 10, 11}));
  EXPECT_FALSE(overlap(even, Vector{-2, -1, 0, 2, 7})) << "7 alone, behind the entries that agree";
  EXPECT_FALSE(overlap(even, Vector{-3, -2, -1, 0, 3})) << "2 and 3, either alone";
}

TEST(Overlap, MissingEntriesAreListedFromEitherSide) {
  const Vector even{0, 2, 4, 6, 8};
  const Vector other{4, 5, 6, 7, 12};
  EXPECT_EQ(missing(even, other), (Vector{8}));
  EXPECT_EQ(missing(other, even), (Vector{5, 7}));
  EXPECT_EQ(missing(even, even), Vector{});
  EXPECT_EQ(missing(Vector{0, 1, 2, 3, 4}, Vector{4, 5, 6, 7, 8}), Vector{}) << "4 is in both";
}

// All strictly ascending vectors of three entries in 0..7, in pairs, against the literal condition; what is missing
// from either side is empty together exactly when they overlap.
TEST(Overlap, AgreesWithTheLiteralConditionOnAllSmallVectors) {
  std::vector<Vector> all;
  for (std::int32_t a = 0; a < 8; ++a) {
    for (std::int32_t b = a + 1; b < 8; ++b) {
      for (std::int32_t c = b + 1; c < 8; ++c) all.push_back({a, b, c});
    }
  }
  ASSERT_EQ(all.size(), 56U);
  for (const Vector& one : all) {
    for (const Vector& other : all) {
      const std::vector<std::int64_t> wide_one(one.begin(), one.end());
      const std::vector<std::int64_t> wide_other(other.begin(), other.end());
      const bool expected = reference::overlap(wide_one, wide_other);
      EXPECT_EQ(overlap(one, other), expected);
      EXPECT_EQ(missing(one, other).empty() && missing(other, one).empty(), expected);
    }
  }
}

}  // namespace
}  // namespace asts
