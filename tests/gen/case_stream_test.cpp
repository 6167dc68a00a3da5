#include "lib/gen/case_stream.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "lib/mesh/case_file.hpp"

namespace asts {
namespace {

TEST(CaseStream, NumbersAndSeedsGiveCasesOfTheirOwn) {
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    for (std::int64_t number = 0; number < 25; ++number) {
      const std::string text = write_case(make_case(plan_case(seed, number)).content);
      EXPECT_EQ(write_case(make_case(plan_case(seed, number)).content), text);
      texts.insert(text);
    }
  }
  EXPECT_GE(texts.size(), 90U);
}

TEST(CaseStream, HasThePlannedSettingAndBias) {
  for (std::int64_t number = 0; number < 200; ++number) {
    const PlannedCase planned = plan_case(1, number);
    const RandomCase made = make_case(planned);
    EXPECT_EQ(made.bias, planned.bias);
    EXPECT_EQ(made.content.degree, planned.setting.degree);
    EXPECT_EQ(made.content.grading, planned.setting.grading);
    EXPECT_EQ(made.content.domain, planned.setting.domain);
    EXPECT_EQ(parse_case(write_case(made.content), "stream"), made.content);
  }
}

// Every bias, m from 2 to 16, degrees from 3 to 9, equal and mixed.
TEST(CaseStream, MixesBiasesGradingsAndDegrees) {
  std::map<Bias, int> biases;
  std::set<int> gradings;
  std::set<PerAxis<int>> degrees;
  int small = 0;
  constexpr int kCases = 3000;
  for (std::int64_t number = 0; number < kCases; ++number) {
    const PlannedCase planned = plan_case(2, number);
    ++biases[planned.bias];
    gradings.insert(planned.setting.grading);
    degrees.insert(planned.setting.degree);
    small += planned.limits.max_elements <= 250;
  }
  EXPECT_EQ(biases.size(), all_biases().size());
  for (const auto& [bias, count] : biases) EXPECT_GE(count, 80) << bias_name(bias);  // 125 expected, deviation 11
  EXPECT_EQ(gradings.size(), 15U);
  EXPECT_EQ(*gradings.begin(), 2);
  EXPECT_EQ(*gradings.rbegin(), 16);
  for (const PerAxis<int>& wanted : {PerAxis<int>{9, 3, 3}, PerAxis<int>{3, 7, 3}, PerAxis<int>{3, 3, 5}}) {
    EXPECT_TRUE(degrees.contains(wanted));
  }
  EXPECT_GE(degrees.size(), 40U);
  EXPECT_GE(2 * small, kCases);
}

}  // namespace
}  // namespace asts
