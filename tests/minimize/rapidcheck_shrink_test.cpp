#include <gtest/gtest.h>
// after GoogleTest
#include <algorithm>

#include "lib/mesh/case_file.hpp"
#include "properties/statement.hpp"
#include "tests/minimize/rapidcheck_shrink.hpp"
#include "tests/minimize/start_cases.hpp"
#include "tests/minimize/start_meshes.hpp"

namespace asts {
namespace {

Case twelve_subdivisions() {
  return parse_case(
      "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 5 5 5\n"
      "subdivide 1/2 1/2 1/2  9/2 9/2 9/2  1/2 9/2 1/2\n"
      "subdivide 5/2 3/2 5/2\nsubdivide 1/4 1/2 1/2  19/4 9/2 9/2\nsubdivide 9/4 3/2 5/2\n"
      "subdivide 9/2 1/2 1/2  9/2 1/2 9/2  1/2 1/2 9/2  1/2 9/2 9/2\nsubdivide 17/4 1/2 1/2\n",
      "twelve");
}

TEST(RapidcheckShrink, MakesACaseSmallerThatStillViolates) {
  const Statement statement = find_statement("as-implies-dc").value();
  const Case start = twelve_subdivisions();
  ASSERT_EQ(size_of(start), 12);
  const auto kind = violation_of(statement, start);
  ASSERT_EQ(kind, "no-partial-overlap");
  const auto fails = [&](const Case& other) { return violation_of(statement, other) == kind; };
  const Shrunk shrunk = shrink_with_rapidcheck(start, fails, 100'000);
  EXPECT_TRUE(fails(shrunk.smallest)) << write_case(shrunk.smallest);
  EXPECT_EQ(size_of(shrunk.smallest), 2) << write_case(shrunk.smallest);
  EXPECT_GT(shrunk.evaluations, 0);
  EXPECT_FALSE(shrunk.stopped);
}

TEST(RapidcheckShrink, EndsAtItsCap) {
  std::int64_t asked = 0;
  const auto fails = [&](const Case&) {
    ++asked;
    return true;
  };
  const Shrunk shrunk = shrink_with_rapidcheck(twelve_subdivisions(), fails, 3);
  EXPECT_TRUE(shrunk.stopped);
  EXPECT_EQ(shrunk.evaluations, 3);
  EXPECT_EQ(asked, 3);
}

// When everything fails, the least case there is is the end.
TEST(RapidcheckShrink, GoesDownToTheEmptyCase) {
  const Shrunk shrunk = shrink_with_rapidcheck(
      twelve_subdivisions(), [](const Case&) { return true; }, 1000);
  EXPECT_EQ(shrunk.smallest, (Case{{3, 3, 3}, 2, {1, 1, 1}, {}, false, {}}));
}

TEST(RapidcheckShrink, ProposesValidCasesOnly) {
  for (const Case& start : {twelve_subdivisions(), violating_start("dc-implies-as", 1)}) {
    const auto fails = [&](const Case& other) {
      EXPECT_EQ(parse_case(write_case(other), "shrunk"), other);
      return size_of(other) >= 3;
    };
    EXPECT_EQ(size_of(shrink_with_rapidcheck(start, fails, 10'000).smallest), 3) << write_case(start);
  }
}

}  // namespace
}  // namespace asts
