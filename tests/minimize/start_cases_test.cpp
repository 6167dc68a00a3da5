#include "tests/minimize/start_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "properties/statement.hpp"
#include "tests/minimize/start_meshes.hpp"

namespace asts {
namespace {

constexpr std::uint64_t kSeeds = 5;

std::string text_of(const Case& test_case) { return test_case.explicit_mesh ? "explicit" : write_case(test_case); }

bool sides_fit(const Case& test_case, std::string_view id) {
  PerAxis<int> longest{kLargestStartSide, kLargestStartSide, kLargestStartSide};
  if (id == "figure-proof-levels") longest = {kLargestStartSide, 25, 25};
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (test_case.domain[axis] < 1 || test_case.domain[axis] > longest[axis]) return false;
  }
  return true;
}

/// Deciding one of these takes a second, so that two seeds have to do.
std::uint64_t seeds_of(std::string_view id) { return id == "distance-bound" || id == "lambda-sums" ? 2 : kSeeds; }

class Starts : public testing::TestWithParam<std::string_view> {};

TEST_P(Starts, ViolateAndAreLarge) {
  const Statement statement = find_statement(GetParam()).value();
  for (std::uint64_t seed = 0; seed < seeds_of(GetParam()); ++seed) {
    const Case start = violating_start(GetParam(), seed);
    EXPECT_FALSE(start.explicit_mesh);
    EXPECT_TRUE(violation_of(statement, start)) << text_of(start);
    EXPECT_GE(size_of(start), kLeastStartSize) << text_of(start);
    EXPECT_TRUE(sides_fit(start, GetParam())) << text_of(start);
    EXPECT_EQ(parse_case(write_case(start), "start"), start) << "a valid case";
  }
}

TEST_P(Starts, DependOnTheSeedAlone) {
  std::vector<Case> starts;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) starts.push_back(violating_start(GetParam(), seed));
  EXPECT_EQ(violating_start(GetParam(), 1), starts[1]);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    EXPECT_EQ(std::count(starts.begin(), starts.end(), starts[i]), 1) << text_of(starts[i]);
  }
}

class ExplicitStarts : public testing::TestWithParam<std::string_view> {};

TEST_P(ExplicitStarts, ViolateAndAreLargeAndDependOnTheSeedAlone) {
  const Statement statement = find_statement(GetParam()).value();
  std::vector<Case> starts;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Case start = violating_explicit_start(GetParam(), seed);
    EXPECT_TRUE(start.explicit_mesh);
    EXPECT_TRUE(violation_of(statement, start)) << write_case(start);
    EXPECT_GE(size_of(start), kLeastStartSize) << write_case(start);
    EXPECT_TRUE(sides_fit(start, GetParam())) << write_case(start);
    EXPECT_EQ(std::count(starts.begin(), starts.end(), start), 0);
    starts.push_back(start);
  }
  EXPECT_EQ(violating_explicit_start(GetParam(), 1), starts[1]);
}

std::string test_name(const testing::TestParamInfo<std::string_view>& info) {
  std::string name(info.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(OfClaims, Starts, testing::ValuesIn(start_claims().begin(), start_claims().end()), test_name);
INSTANTIATE_TEST_SUITE_P(OfStatements, ExplicitStarts,
                         testing::ValuesIn(explicit_start_ids().begin(), explicit_start_ids().end()), test_name);

TEST(StartClaims, AreTheRefutedOnes) {
  for (const Claim& claim : all_claims()) {
    const bool has_starts = std::count(start_claims().begin(), start_claims().end(), claim.id) == 1;
    EXPECT_EQ(has_starts, claim.refuted) << claim.id;
  }
  EXPECT_THROW(violating_start("overlay", 0), InputError);
  EXPECT_THROW(violating_explicit_start("lambda-sums", 0), InputError);
}

TEST(StartSize, CountsSubdividedElementsOrBoxes) {
  Case steps{{3, 3, 3}, 3, {2, 1, 1}, {}, false, {}};
  EXPECT_EQ(size_of(steps), 0);
  steps.steps = {{Step::Kind::subdivide, {Point{}}}, {Step::Kind::subdivide, {Point{}}}};
  EXPECT_EQ(size_of(steps), 2);
  Draw draw(1);
  EXPECT_EQ(size_of(as_boxes(draw, steps)), 4) << "each of the two subdivisions makes three boxes of one";
  steps.steps = {{Step::Kind::refine, {Point{}}}, {Step::Kind::refine, {Point{}}}};
  const std::int64_t size = size_of(steps);
  steps.grading = 1300;
  EXPECT_EQ(size_of(steps), size - 1) << "[1,2] is in the patch of [0,1/3], not of [0,1/1300]; followed without a mesh";
}

}  // namespace
}  // namespace asts
