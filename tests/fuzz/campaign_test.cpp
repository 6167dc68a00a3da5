#include "fuzz/campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstring>
#include <thread>

#include "lib/mesh/case_file.hpp"

namespace asts::testing {
namespace {

/// Meshes that the faulty claims below do not survive: about one case in 75.
bool is_deadly(MeshUnderTest& mesh) { return mesh.mesh().setting.grading == 7; }

Trial met() { return {Verdict::holds(), 1}; }

Trial crashes(MeshUnderTest& mesh) {
  if (is_deadly(mesh)) std::raise(SIGSEGV);
  return met();
}

Trial hangs(MeshUnderTest& mesh) {
  std::atomic<bool> ends{!is_deadly(mesh)};
  while (!ends) std::this_thread::yield();
  return met();
}

Trial takes_all_memory(MeshUnderTest& mesh) {
  std::vector<std::vector<char>> taken;
  while (is_deadly(mesh)) taken.emplace_back(1 << 20, 'x');
  return met();
}

Trial throws(MeshUnderTest& mesh) {
  if (is_deadly(mesh)) throw InternalError("an invariant does not hold");
  return met();
}

Trial survives(MeshUnderTest&) { return met(); }

Claim claim_of(Trial (*on_mesh)(MeshUnderTest&)) {
  Claim claim{"faulty", "none", "a claim for tests", ClaimKind::remark, "", "meshes", false};
  claim.on_mesh = on_mesh;
  claim.max_elements = 1'000'000;
  return claim;
}

constexpr std::int64_t kCases = 192;

CampaignResult run(const Claim& claim) {
  CampaignPlan plan;
  plan.claims = {&claim};
  plan.seed = 5;
  CampaignRun how;
  how.cases = kCases;
  how.limits = {1, 400};
  return run_campaign(plan, how, nullptr);
}

/// What a faulty claim gives; nothing of the campaign is lost but the cases that are deadly.
CampaignFinding only_finding(Trial (*on_mesh)(MeshUnderTest&), const char* kind) {
  const Claim faulty = claim_of(on_mesh);
  const CampaignResult result = run(faulty);
  const CampaignSummary& summary = result.summary;
  const CampaignResult sound = run(claim_of(survives));
  EXPECT_LT(summary.cases, kCases) << "no case is deadly";
  EXPECT_GT(summary.cases, kCases * 9 / 10);
  EXPECT_EQ(summary.records[0].holds, summary.records[0].met);
  EXPECT_LT(summary.records[0].holds, sound.summary.records[0].holds);
  EXPECT_GT(summary.records[0].holds, sound.summary.records[0].holds * 9 / 10);
  EXPECT_EQ(sound.summary.cases, kCases);
  EXPECT_TRUE(sound.summary.findings.empty());
  EXPECT_EQ(summary.findings.size(), 1U);
  if (summary.findings.empty()) return {};
  const CampaignFinding& finding = summary.findings[0];
  EXPECT_EQ(finding.claim, "faulty");
  EXPECT_EQ(finding.kind, kind);
  EXPECT_FALSE(finding.expected);
  EXPECT_TRUE(finding.content.has_value());
  EXPECT_EQ(finding.content->grading, 7);
  return finding;
}

// Law 3.
TEST(Campaign, GoesOnAfterACrash) {
  const CampaignFinding finding = only_finding(crashes, "crash");
  EXPECT_EQ(finding.says, "signal 11 (Segmentation fault)");
  ASSERT_TRUE(finding.minimized);
  EXPECT_EQ(finding.minimized->guarantee, Guarantee::one_minimal);
  EXPECT_EQ(write_case(*finding.content), "asts-case 1\ndegree 3 3 3\ngrading 7\ndomain 1 1 1\n");
  EXPECT_EQ(finding.file.find("findings/faulty-crash-"), 0U);
}

TEST(Campaign, GoesOnAfterAnException) {
  const CampaignFinding finding = only_finding(throws, "exception");
  EXPECT_NE(finding.says.find("an invariant does not hold"), std::string::npos) << finding.says;
  EXPECT_EQ(write_case(*finding.content), "asts-case 1\ndegree 3 3 3\ngrading 7\ndomain 1 1 1\n");
}

// Not made smaller: each evaluation would take its time.
TEST(Campaign, GoesOnWhenACaseHangs) {
  const CampaignFinding finding = only_finding(hangs, "timeout");
  EXPECT_EQ(finding.says, "no end within 1 s");
  EXPECT_FALSE(finding.minimized);
}

TEST(Campaign, GoesOnWhenACaseTakesTooMuchMemory) {
#if !defined(__SANITIZE_ADDRESS__)
  const CampaignFinding finding = only_finding(takes_all_memory, "memory");
  EXPECT_EQ(finding.says, "no memory within the limit");
  EXPECT_FALSE(finding.minimized);
#endif
}

CampaignPlan theorem_plan() {
  CampaignPlan plan;
  for (const char* id : {"as-implies-dc", "dc-implies-as", "child-distance", "lambda-sums", "figure-slices"}) {
    plan.claims.push_back(find_claim(id));
  }
  return plan;
}

// Laws 1 and 4.
TEST(Campaign, GivesTheSameForAnyNumberOfJobs) {
  const CampaignPlan plan = theorem_plan();
  CampaignRun how;
  how.cases = 300;
  const CampaignSummary one = run_campaign(plan, how, nullptr).summary;
  how.jobs = 3;
  const CampaignSummary three = run_campaign(plan, how, nullptr).summary;
  EXPECT_EQ(one.cases, 300);
  EXPECT_EQ(three.cases, 300);
  EXPECT_EQ(one.distinct, three.distinct);
  EXPECT_EQ(one.trivial, three.trivial);
  EXPECT_EQ(one.generated, three.generated);
  EXPECT_EQ(one.biases, three.biases);
  ASSERT_EQ(one.findings.size(), three.findings.size());
  EXPECT_GE(one.findings.size(), 2U);
  for (std::size_t i = 0; i < one.findings.size(); ++i) {
    EXPECT_EQ(one.findings[i].content, three.findings[i].content);
    EXPECT_EQ(one.findings[i].number, three.findings[i].number);
    EXPECT_EQ(one.findings[i].valid.value_or(false), one.findings[i].content.has_value()) << one.findings[i].validation;
  }
  EXPECT_EQ(one.records[0].meshes, three.records[0].meshes);
  EXPECT_LE(one.records[0].meshes, one.distinct);
  EXPECT_LT(one.distinct, one.meshes);
}

TEST(Campaign, EndsWhenItIsTold) {
  const CampaignPlan plan = theorem_plan();
  CampaignRun how;
  how.cases = 1'000'000;
  int asked = 0;
  how.stop = [&asked] { return ++asked > 5; };
  const CampaignResult result = run_campaign(plan, how, nullptr);
  EXPECT_TRUE(result.interrupted);
  EXPECT_LT(result.summary.cases, 1'000'000);
}

TEST(Campaign, EndsWithItsTime) {
  const CampaignPlan plan = theorem_plan();
  CampaignRun how;
  how.time = std::chrono::seconds(1);
  const CampaignResult result = run_campaign(plan, how, nullptr);
  EXPECT_FALSE(result.interrupted);
  EXPECT_EQ(result.summary.cases % kBlockCases, 0);
  EXPECT_GT(result.summary.cases, 0);
}

// A case of a collection that does what it did is no finding.
TEST(Campaign, DecidesStoredCasesFirst) {
  const std::string small = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 5\n";
  CampaignPlan plan;
  plan.claims = {find_claim("as-implies-dc"), find_claim("as-implies-dc-repaired")};
  const Case violating = parse_case(small + "subdivide 1 1 1\nsubdivide 3/2 1 1\n", "violating");
  const Case harmless = parse_case(small, "harmless");
  plan.stored = {{"as-implies-dc.case", plan.claims[0], "no-partial-overlap", violating},
                 {"as-implies-dc-other.case", plan.claims[0], "other", violating},
                 {"as-implies-dc-harmless.case", plan.claims[0], "", harmless},
                 {"as-implies-dc-repaired.case", plan.claims[1], "", violating}};
  CampaignRun how;
  how.cases = 1;
  const CampaignSummary summary = run_campaign(plan, how, nullptr).summary;
  EXPECT_EQ(summary.cases, 1);
  EXPECT_EQ(summary.biases.at("stored"), 4);
  ASSERT_EQ(summary.findings.size(), 2U);
  EXPECT_EQ(summary.findings[0].number, -2);
  EXPECT_EQ(summary.findings[0].kind, "no-partial-overlap");
  EXPECT_EQ(summary.findings[1].number, -3);
  EXPECT_EQ(summary.findings[1].kind, "not-violated");
  EXPECT_FALSE(summary.findings[1].expected);
  EXPECT_NE(summary.findings[1].says.find("as-implies-dc-harmless.case was recorded otherwise"), std::string::npos);
}

}  // namespace
}  // namespace asts::testing
