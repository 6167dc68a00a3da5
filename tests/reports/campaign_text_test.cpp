#include "reports/campaign_text.hpp"

#include <gtest/gtest.h>

#include "tests/reports/campaign_example.hpp"

namespace asts {
namespace {

TEST(CampaignText, SaysHowOftenCodeDidNotComeBack) {
  auto [summary, problems] = testing::campaign_example();
  summary.deaths = 3;
  EXPECT_NE(campaign_text(summary, problems).find("initial meshes\nthe code under test did not come back 3 times\n"),
            std::string::npos);
}

TEST(CampaignText, SaysWhatWasTriedAndFoundAndHowWell) {
  const auto [summary, problems] = testing::campaign_example();
  EXPECT_EQ(campaign_text(summary, problems),
            R"(asts 1.2.3: 5 claims, seed 7
20 cases, 6 of them sequences of refine steps
60 meshes, 50 distinct, 9 of these initial meshes

claim                            status    result          meshes sequences alone  trials-met          met  violated undecided
patches-nested                   unrefuted no-violation        40         0     0          40          100         0         0
as-implies-dc                    refuted   violated            40         0     0          40          200         3         0
as-implies-dc-repaired           unrefuted violated            40         0     0          40          200         1         0
closure-least                    unrefuted no-violation        40         0     0          40           90         0         0
sigma-unperturbed                unrefuted undecided           40         0     0           0            0         0         0

findings: 4, 3 of them unexpected

as-implies-dc: no-partial-overlap: findings/as-implies-dc-no-partial-overlap-00ff.case
    2 subdivisions, 2 steps, 4 x 4 x 5 cubes, p = (3,3,3), m = 2, level 2, 1-minimal after 123 evaluations
    first met in case 17, step 2
    the literal code says: valid
    v and w share volume
    and do not overlap

UNEXPECTED as-implies-dc-repaired: no-partial-overlap: findings/as-implies-dc-repaired-no-partial-overlap-00ff.case
    2 subdivisions, 2 steps, 4 x 4 x 5 cubes, p = (3,3,3), m = 2, level 2, 1-minimal after 123 evaluations
    first met in case 17, step 2
    the literal code says: valid
    v and w share volume
    and do not overlap

UNEXPECTED closure-least: timeout: findings/closure-least-timeout-00ff.case
    as drawn, not minimized
    first met in case 17, step 2
    no end within 60 s

UNEXPECTED while no claim was tried: crash: findings/none-crash-00ff.case
    as drawn, not minimized
    first met in case 17, step 2
    no end within 60 s

health: 2 problems
    hypothesis-never-met sigma-unperturbed: its hypothesis was met in none of 40 trials
    trivial-meshes: 30 of 50
)");
}

TEST(CampaignText, SaysThatAllIsWell) {
  CampaignSummary summary = testing::campaign_example().summary;
  summary.findings.clear();
  summary.claims.resize(1);
  summary.records.resize(1);
  const std::string text = campaign_text(summary, {});
  EXPECT_NE(text.find("asts 1.2.3: 1 claim, seed 7\n"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("\n\nfindings: 0, 0 of them unexpected\n\nhealth: good\n")) << text;
}

TEST(CampaignText, TellsWhereAFindingComesFromAndWhatIsNotValid) {
  CampaignFinding finding = testing::example_finding("size-formula", "wrong-size", false);
  finding.number = -3;
  finding.valid = false;
  finding.validation = "the element is not in the mesh";
  EXPECT_NE(finding_text(finding).find("first met in stored case 3\nthe literal code says: NOT VALID: the element is "
                                       "not in the mesh\n"),
            std::string::npos);
  finding = {};
  finding.claim = "size-formula";
  finding.kind = "exception";
  finding.says = "what happened";
  EXPECT_EQ(finding_text(finding), "tried without a case\nwhat happened\n");
  EXPECT_TRUE(is_death(finding));
  EXPECT_FALSE(is_death(testing::example_finding("size-formula", "wrong-size", false)));
}

}  // namespace
}  // namespace asts
