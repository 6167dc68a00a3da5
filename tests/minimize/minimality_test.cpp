#include <gtest/gtest.h>

#include <algorithm>

#include "lib/mesh/case_file.hpp"
#include "lib/minimize/minimize.hpp"
#include "properties/statement.hpp"
#include "tests/minimize/planted_faults.hpp"
#include "tests/minimize/start_cases.hpp"

namespace asts {
namespace {

/// The least size known of what a claim's, or a planted fault's, start cases come to. The minimizer reaches it from
/// every start: found by minimizing, none of them by hand, and, where the enumeration fits, proved (asts minimize
/// --prove; reports/minimality.md has the scopes).
struct Least {
  const char* id;
  CaseSize size;  ///< boxes, subdivisions, steps, volume, p1 + p2 + p3, m, depth
  int starts;
};

const Least kClaims[] = {
    {"as-implies-dc", {false, 2, 2, 80, 9, 2, 2}, 10},
    {"dc-implies-as", {false, 4, 2, 200, 9, 2, 2}, 10},
    {"as-implies-dual-basis", {false, 2, 2, 100, 9, 2, 2}, 10},
    {"case-table", {false, 2, 2, 200, 9, 2, 2}, 10},
    {"new-node-split", {false, 0, 0, 64, 9, 2, 0}, 10},
    {"perturbed-cover-hanging", {false, 1, 1, 2, 9, 2, 1}, 10},
    {"planar-equals-classical", {false, 16, 2, 200, 9, 3, 2}, 10},
    {"frame-in-index-sets", {false, 0, 0, 1, 11, 2, 0}, 10},
    {"child-distance", {false, 1, 1, 1, 9, 3, 1}, 10},
    {"child-distance-bound", {false, 1, 1, 1, 9, 3, 1}, 10},
    {"figure-proof-levels", {false, 242, 4, 1785, 9, 2, 4}, 2},
    {"distance-bound", {false, 1, 1, 2, 9, 1315, 1}, 2},
};

const Least kFaults[] = {
    {"single-round", {false, 8, 3, 2, 9, 5, 3}, 5},        {"closed-environment", {false, 2, 2, 2, 9, 5, 2}, 5},
    {"level-of-few-splits", {false, 6, 6, 1, 9, 2, 6}, 5}, {"late-index-vector", {false, 2, 2, 80, 9, 2, 2}, 5},
    {"mixed-frame", {false, 1, 1, 120, 11, 2, 1}, 5},      {"overlap-along-all-axes", {false, 1, 1, 80, 9, 2, 1}, 5},
    {"slices-of-domain", {false, 2, 2, 80, 9, 2, 2}, 5},
};

/// One line: test discovery reads it.
void PrintTo(const Least& least, std::ostream* out) { *out << least.id; }

std::string described(const Minimized& result) {
  return std::to_string(result.size.subdivisions) + " subdivisions, volume " + std::to_string(result.size.volume) +
         "\n" + write_case(result.smallest);
}

/// The figure's mesh has 242 subdivisions that must all be there, each looked at more than once.
constexpr std::int64_t kMostForFigure = 3000;

/// From every start to the least size, in at most 1000 evaluations at the median, which is recorded.
void reach(const Least& least, PathForm form, const Predicate& violation,
           const std::function<Case(std::uint64_t)>& start) {
  std::vector<std::int64_t> evaluations;
  for (int seed = 0; seed < least.starts; ++seed) {
    const Case first = start(static_cast<std::uint64_t>(seed));
    const Minimized result = minimize(first, form, violation, {});
    EXPECT_TRUE(result.size == least.size) << "from\n" << write_case(first) << "comes " << described(result);
    EXPECT_EQ(result.guarantee, Guarantee::one_minimal);
    evaluations.push_back(result.evaluations);
  }
  std::sort(evaluations.begin(), evaluations.end());
  const std::int64_t median = evaluations[evaluations.size() / 2];
  EXPECT_LE(median, least.size.subdivisions == 242 ? kMostForFigure : 1000);
  ::testing::Test::RecordProperty("median evaluations", static_cast<int>(median));
}

class LeastOfClaims : public ::testing::TestWithParam<Least> {};

TEST_P(LeastOfClaims, IsReachedFromEveryStart) {
  const Least& least = GetParam();
  const Statement statement = find_statement(least.id).value();
  reach(
      least, PathForm::mesh, [&](const Case& one) { return violation_of(statement, one); },
      [&](std::uint64_t seed) { return violating_start(least.id, seed); });
}

INSTANTIATE_TEST_SUITE_P(Minimality, LeastOfClaims, ::testing::ValuesIn(kClaims));

class LeastOfFaults : public ::testing::TestWithParam<Least> {};

TEST_P(LeastOfFaults, IsReachedFromEveryStart) {
  const auto faults = planted_faults();
  const auto fault = std::find_if(faults.begin(), faults.end(),
                                  [](const PlantedFault& one) { return one.name == std::string(GetParam().id); });
  ASSERT_NE(fault, faults.end());
  reach(GetParam(), fault->form, fault->predicate, fault->start);
}

INSTANTIATE_TEST_SUITE_P(Minimality, LeastOfFaults, ::testing::ValuesIn(kFaults));

}  // namespace
}  // namespace asts
