#include <gtest/gtest.h>

#include <algorithm>
#include <unordered_set>

#include "lib/gen/case_stream.hpp"
#include "lib/mesh/fingerprint.hpp"
#include "lib/refine/replay.hpp"
#include "properties/campaign/health.hpp"

namespace asts {
namespace {

/// A campaign that everything is well with.
CampaignSummary healthy() {
  CampaignSummary summary;
  summary.cases = 400;
  summary.meshes = 1200;
  summary.distinct = 1000;
  summary.trivial = 150;
  for (const Bias bias : all_biases()) summary.biases[bias_name(bias)] = 15;
  for (const char* claim : {"patches-nested", "as-implies-dc"}) {
    LedgerRecord record;
    record.claim = claim;
    record.meshes = record.holds = 900;
    record.met = record.trials_met = 800;
    summary.records.push_back(record);
  }
  return summary;
}

/// "check subject" of each problem.
std::vector<std::string> problems_of(const CampaignSummary& summary) {
  std::vector<std::string> result;
  for (const HealthProblem& problem : check_health(summary)) {
    EXPECT_FALSE(problem.says.empty());
    result.push_back(problem.check + " " + problem.subject);
  }
  return result;
}

using Problems = std::vector<std::string>;

TEST(CampaignHealth, IsGoodWithoutProblems) { EXPECT_EQ(problems_of(healthy()), Problems{}); }

TEST(CampaignHealth, SaysWhenMoreThanHalfOfTheMeshesAreTrivial) {
  CampaignSummary summary = healthy();
  summary.trivial = 500;
  EXPECT_EQ(problems_of(summary), Problems{});
  summary.trivial = 501;
  EXPECT_EQ(problems_of(summary), Problems{"trivial-meshes "});
  EXPECT_EQ(check_health(summary).front().says, "501 of 1000 distinct meshes are initial meshes, more than one in 2");
  summary.meshes = summary.distinct = summary.trivial = 99;
  EXPECT_EQ(problems_of(summary), Problems{}) << "too few to tell";
}

TEST(CampaignHealth, SaysWhenMostMeshesAreRepeated) {
  CampaignSummary summary = healthy();
  summary.meshes = 4000;
  EXPECT_EQ(problems_of(summary), Problems{});
  summary.meshes = 4001;
  EXPECT_EQ(problems_of(summary), Problems{"repeated-meshes "});
  EXPECT_EQ(check_health(summary).front().says, "1000 of 4001 meshes are distinct, fewer than one in 4");
  summary.meshes = 999;
  summary.distinct = summary.trivial = 1;
  EXPECT_EQ(problems_of(summary), Problems{}) << "too few to tell";
}

TEST(CampaignHealth, SaysWhichClaimsWereNeverTestedHoweverShortTheCampaign) {
  for (const std::int64_t cases : {1, 400}) {
    CampaignSummary summary = healthy();
    summary.cases = cases;
    summary.records[0].met = summary.records[0].trials_met = 0;
    summary.records[1] = {};
    summary.records[1].claim = "as-implies-dc";
    EXPECT_EQ(problems_of(summary), (Problems{"never-tried as-implies-dc", "hypothesis-never-met patches-nested"}));
    EXPECT_EQ(check_health(summary)[1].says, "its hypothesis was met in none of 900 trials");
  }
}

// What is violated, and what is decided without a mesh, has said something.
TEST(CampaignHealth, CountsViolationsAndTrialsWithoutAMesh) {
  CampaignSummary summary = healthy();
  summary.records[0].met = summary.records[0].trials_met = 0;
  summary.records[0].violated = 1;
  summary.records[1] = {};
  summary.records[1].claim = "example-table";
  summary.records[1].alone = summary.records[1].holds = summary.records[1].trials_met = 1;
  summary.records[1].met = 3;
  EXPECT_EQ(problems_of(summary), Problems{});
}

/// With so many draws of the biases, each of which occurs but for those without a count.
CampaignSummary with_draws(std::int64_t draws, const std::vector<std::string>& without) {
  CampaignSummary summary = healthy();
  for (auto& [bias, count] : summary.biases) count = 1;
  for (const std::string& bias : without) summary.biases[bias] = 0;
  for (const auto& [bias, count] : summary.biases) draws -= count;
  summary.biases["marks-anywhere"] += draws;
  return summary;
}

// (25/26)^352 = 1.01 * 10^-6, (25/26)^353 = 0.97 * 10^-6.
TEST(CampaignHealth, SaysWhichBiasNeverFiredWhenItCannotBeChance) {
  ASSERT_EQ(all_biases().size(), 26U);
  EXPECT_EQ(problems_of(with_draws(352, {"boxes-pinwheel"})), Problems{});
  EXPECT_EQ(problems_of(with_draws(353, {"boxes-pinwheel"})), Problems{"bias-never-fired boxes-pinwheel"});
  CampaignSummary summary = with_draws(353, {"boxes-pinwheel", "marks-deep"});
  EXPECT_EQ(problems_of(summary), (Problems{"bias-never-fired marks-deep", "bias-never-fired boxes-pinwheel"}));
  EXPECT_EQ(check_health(summary).front().says, "no case was drawn for it in 353 draws of a bias");
  summary.biases.clear();
  EXPECT_EQ(problems_of(summary), Problems{}) << "not counted, not asked about";
  summary = with_draws(352, {"boxes-pinwheel"});
  summary.biases["stored"] = 5000;
  summary.biases["provoke-case-table"] = 5000;
  EXPECT_EQ(problems_of(summary), Problems{}) << "these are no draws of a bias";
}

// In blocks of 64 cases: (15/16)^214 = 1.004 * 10^-6, (15/16)^215 = 0.94 * 10^-6.
TEST(CampaignHealth, SaysWhichProvocationWasNeverDrawn) {
  const auto summary_of = [](std::int64_t cases) {
    CampaignSummary summary = with_draws(cases, {});
    summary.biases["provoke-distance-bound"] = 0;  // once in 16 blocks
    summary.biases["stored"] = 640;
    return summary;
  };
  EXPECT_EQ(problems_of(summary_of(64 * 215 - 1)), Problems{});
  EXPECT_EQ(problems_of(summary_of(64 * 215)), Problems{"bias-never-fired provoke-distance-bound"});
  CampaignSummary summary = summary_of(63);
  summary.biases["provoke-dc-implies-as"] = 0;  // in every block
  EXPECT_EQ(problems_of(summary), Problems{});
  ++summary.biases["provoke-case-table"];
  EXPECT_EQ(problems_of(summary), Problems{"bias-never-fired provoke-dc-implies-as"}) << "a whole block";
}

/// What a campaign counts about meshes and biases.
void count_case(const Case& content, std::unordered_set<Fingerprint, FingerprintHash>& seen, CampaignSummary& summary) {
  const auto count = [&](const Mesh& mesh, bool trivial) {
    ++summary.meshes;
    if (seen.insert(fingerprint_of(mesh)).second) summary.trivial += trivial;
  };
  if (content.explicit_mesh) return count(mesh_of(setting_of(content), content.elements), false);
  Replay replay(content);
  count(mesh_of(replay.tree()), true);
  while (!replay.done()) {
    replay.advance();
    count(mesh_of(replay.tree()), false);
  }
}

TEST(CampaignHealth, IsGoodOnTheStreamOfCases) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    CampaignSummary summary;
    std::unordered_set<Fingerprint, FingerprintHash> seen;
    for (const Bias bias : all_biases()) summary.biases[bias_name(bias)] = 0;
    for (; summary.cases < 700; ++summary.cases) {
      const RandomCase made = make_case(plan_case(seed, summary.cases));
      ++summary.biases[bias_name(made.bias)];
      count_case(made.content, seen, summary);
      summary.distinct = static_cast<std::int64_t>(seen.size());
      EXPECT_EQ(problems_of(summary), Problems{}) << "seed " << seed << ", " << summary.cases << " cases";
    }
    EXPECT_GT(5 * summary.distinct, 4 * summary.meshes);
    EXPECT_LT(5 * summary.trivial, summary.distinct);
  }
}

constexpr std::int64_t kSecond = 1'000'000;

TEST(CampaignSpeed, SaysWhichCaseIsSlowerThanItsShare) {
  EXPECT_FALSE(check_speed({1000, 200 * kSecond, 20 * kSecond, 17})) << "just one part in 10";
  const auto problem = check_speed({1000, 200 * kSecond, 20 * kSecond + 1, 17});
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->check, "slow-case");
  EXPECT_EQ(problem->subject, "17");
  EXPECT_EQ(problem->says, "case 17 took 20000001 of 200000000 microseconds for 1000 cases");
  EXPECT_FALSE(check_speed({1000, 20 * kSecond, 10 * kSecond, 17})) << "half of the time, but just 10 seconds";
  EXPECT_TRUE(check_speed({1000, 20 * kSecond, 10 * kSecond + 1, 17}));
  EXPECT_FALSE(check_speed({3, 36 * kSecond, 13 * kSecond, 2})) << "three cases of the same kind";
  EXPECT_FALSE(check_speed({}));
  constexpr std::int64_t kLarge = std::numeric_limits<std::int64_t>::max();
  EXPECT_TRUE(check_speed({1000, kLarge, kLarge / 2, 17})) << "no overflow";
}

}  // namespace
}  // namespace asts
