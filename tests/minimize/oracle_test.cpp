#include "lib/minimize/oracle.hpp"

#include <gtest/gtest.h>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/minimize/drop_chunks.hpp"

namespace asts {
namespace {

Case of_domain(int x) {
  Case result;
  result.domain = {x, 1, 1};
  return result;
}

/// Violated in one way by odd domains, in another by 4, undecidable for 6.
ViolationKind odd(const Case& test_case) {
  if (test_case.domain[0] == 6) throw ResourceError("too large");
  if (test_case.domain[0] == 4) return "four";
  return test_case.domain[0] % 2 == 1 ? ViolationKind("odd") : std::nullopt;
}

TEST(Oracle, AsksEachCaseOnce) {
  Oracle oracle(odd, of_domain(9), {});
  EXPECT_EQ(oracle.kind(), "odd");
  EXPECT_EQ(oracle.evaluations(), 1);
  EXPECT_TRUE(oracle.asks(of_domain(9)));
  EXPECT_TRUE(oracle.asks(of_domain(3)));
  EXPECT_FALSE(oracle.asks(of_domain(2)));
  EXPECT_FALSE(oracle.asks(of_domain(2)));
  EXPECT_EQ(oracle.evaluations(), 3);
}

TEST(Oracle, KeepsOtherViolationsAndWhatCannotBeDecidedApart) {
  Oracle oracle(odd, of_domain(9), {});
  EXPECT_FALSE(oracle.asks(of_domain(4)));
  EXPECT_FALSE(oracle.asks(of_domain(6)));
  ASSERT_EQ(oracle.others().size(), 1U);
  EXPECT_EQ(oracle.others().at("four"), of_domain(4));
}

// Only what is too large is no violation: an error of our own must not make the minimizer look elsewhere.
TEST(Oracle, PassesInternalErrorsOn) {
  const Predicate fails = [](const Case& test_case) -> ViolationKind {
    if (test_case.domain[0] < 9) throw InternalError("a fault of the decision");
    return "odd";
  };
  Oracle oracle(fails, of_domain(9), {});
  EXPECT_THROW(oracle.asks(of_domain(7)), InternalError);
}

TEST(Oracle, StopsWhenToldOrWhenTheBudgetIsUsedUp) {
  EXPECT_THROW(Oracle(odd, of_domain(2), {}), InputError);
  Oracle two(odd, of_domain(9), {.budget = 2, .stop = {}, .evaluated = {}});
  EXPECT_TRUE(two.asks(of_domain(7)));
  EXPECT_TRUE(two.asks(of_domain(7))) << "known";
  EXPECT_THROW(two.asks(of_domain(5)), Oracle::Stopped);
  bool stop = false;
  Oracle stopped(odd, of_domain(9), {.budget = 0, .stop = [&] { return stop; }, .evaluated = {}});
  EXPECT_TRUE(stopped.asks(of_domain(7)));
  stop = true;
  EXPECT_TRUE(stopped.asks(of_domain(7)));
  EXPECT_THROW(stopped.asks(of_domain(5)), Oracle::Stopped);
}

/// Drops from 0..n-1 what is not needed, and counts the attempts.
std::pair<std::vector<int>, int> reduce(int n, const std::vector<int>& needed) {
  std::vector<int> entries(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) entries[static_cast<std::size_t>(i)] = i;
  int attempts = 0;
  drop_chunks([&] { return entries.size(); },
              [&](std::size_t first, std::size_t count) {
                ++attempts;
                const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(first);
                const auto end = begin + static_cast<std::ptrdiff_t>(count);
                for (const int one : needed) {
                  if (std::find(begin, end, one) != end) return false;
                }
                entries.erase(begin, end);
                return true;
              });
  return {entries, attempts};
}

TEST(DropChunks, LeavesWhatIsNeededAfterFewAttempts) {
  EXPECT_EQ(reduce(0, {}).first, (std::vector<int>{}));
  EXPECT_EQ(reduce(5, {}), (std::pair{std::vector<int>{}, 1}));
  const auto [left, attempts] = reduce(1000, {3, 500, 999});
  EXPECT_EQ(left, (std::vector<int>{3, 500, 999}));
  EXPECT_LT(attempts, 80);
}

}  // namespace
}  // namespace asts
