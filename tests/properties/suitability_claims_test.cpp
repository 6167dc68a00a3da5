#include "tests/reference/suitability_claims.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "lib/gen/enumerate.hpp"
#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "properties/claims/case_table.hpp"
#include "properties/claims/perturbed_overlap.hpp"
#include "properties/claims/suitability_chain.hpp"
#include "properties/claims/weak_overlap.hpp"
#include "properties/describe.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/properties/suitability_meshes.hpp"

namespace asts {
namespace {

std::string outcome(const char* claim, MeshUnderTest& mesh) {
  return outcome_name(try_on_mesh(*find_claim(claim), mesh).verdict.outcome);
}

// The smallest analysis-suitable mesh that is not dual-compatible: two subdivisions of 4 x 4 x 5 cubes.
TEST(SuitabilityClaims, SlicesOutsideTheActiveRegionAreNotSeen) {
  LastMesh mesh(finding("as-implies-dc"));
  EXPECT_EQ(outcome("as-implies-dc", *mesh), "violated");
  EXPECT_EQ(outcome("as-implies-dc-repaired", *mesh), "not-applicable");
  EXPECT_EQ(outcome("dc-implies-as", *mesh), "not-applicable");
  EXPECT_EQ(outcome("as-implies-dual-basis", *mesh), "holds");
  EXPECT_FALSE((*mesh).meeting_regions());
  const Meeting meeting = find_meeting_in_whole_domain(*mesh);
  ASSERT_TRUE(meeting);
  EXPECT_EQ(describe_meeting(*mesh, *meeting).point, (ExactPoint{Rational(3) / 2, Rational(3) / 2, 1}));
}

TEST(SuitabilityClaims, NoDualBasisThoughAnalysisSuitable) {
  LastMesh mesh(finding("as-implies-dual-basis"));
  EXPECT_EQ(outcome("as-implies-dual-basis", *mesh), "violated");
  EXPECT_EQ(outcome("as-implies-dual-basis-repaired", *mesh), "not-applicable");
  EXPECT_EQ(outcome("dc-implies-dual-basis", *mesh), "not-applicable");
  EXPECT_EQ((*mesh).dual_failures().failures, 2);
}

TEST(SuitabilityClaims, SupportsThatOnlyTouchKeepTheMeshCompatible) {
  LastMesh mesh(finding("dc-implies-as"));
  EXPECT_EQ(outcome("dc-implies-as", *mesh), "violated");
  EXPECT_EQ(outcome("dc-implies-as-repaired", *mesh), "not-applicable");
  EXPECT_EQ(outcome("case-table", *mesh), "violated");
  EXPECT_EQ(outcome("case-table-repaired", *mesh), "holds");
  EXPECT_EQ(outcome("dc-implies-dual-basis", *mesh), "holds");
  const auto pair = find_incompatible_meeting((*mesh).splines(), (*mesh).bricks());
  ASSERT_TRUE(pair);
  const TSplines& splines = (*mesh).splines();
  EXPECT_EQ(splines.support(pair->v, 2).upper, splines.support(pair->w, 2).lower);
}

// Supports share volume here, and R_x and R_y meet: all of Theorem 6.6 is as printed.
TEST(SuitabilityClaims, CrossingRegionsRefuteDualCompatibility) {
  LastMesh mesh(crossing());
  EXPECT_EQ(outcome("as-implies-dc", *mesh), "not-applicable");
  EXPECT_EQ(outcome("dc-implies-as", *mesh), "not-applicable");
  EXPECT_EQ(outcome("case-table", *mesh), "holds");
  EXPECT_EQ(outcome("perturbed-means-no-overlap", *mesh), "holds");
  for (const Claim& claim : suitability_claims()) EXPECT_NE(outcome(claim.id, *mesh), "violated") << claim.id;
}

// One subdivision makes x-orthogonal faces only: overlap fails along x alone.
TEST(SuitabilityClaims, MetCountsWhatIsNotAMatterOfCourse) {
  LastMesh uniform(text_case("domain 5 5 5\n"));
  EXPECT_EQ(as_implies_dc(*uniform).met, 0);
  EXPECT_EQ(dc_implies_as(*uniform).met, 0);
  EXPECT_EQ(perturbed_means_no_overlap(*uniform).met, 0);
  EXPECT_EQ(dc_within_weak_dc(*uniform).met, 0);
  LastMesh once(text_case("domain 6 6 6\nsubdivide 5/2 5/2 5/2\n"));
  EXPECT_GT(as_implies_dc(*once).met, 0);
  EXPECT_EQ(dc_implies_as(*once).met, 1);  // R_y and R_z are empty
  EXPECT_GT(perturbed_means_no_overlap(*once).met, 0);
  EXPECT_GT(dc_within_weak_dc(*once).met, 0);
}

// With the heads as printed, 10 of the 16 situations have a row that does not list the cases that apply.
TEST(SuitabilityClaims, CaseTableNeedsOtherHeads) {
  EXPECT_EQ(case_table(Extent::short_run).verdict.outcome, Outcome::violated);
  EXPECT_EQ(case_table_repaired(Extent::short_run).verdict.outcome, Outcome::holds);
  EXPECT_EQ(case_table_repaired(Extent::short_run).met, 16);
  EXPECT_EQ(reference::wrong_rows(true), 10);
  EXPECT_EQ(reference::wrong_rows(false), 0);
  const auto literal = reference::printed_cases();
  ASSERT_EQ(printed_case_table().size(), literal.size());
  for (std::size_t row = 0; row < literal.size(); ++row) {
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(printed_case_table()[row].heads[i], literal[row].heads[i] == 'T') << literal[row].heads;
    }
    EXPECT_EQ(printed_case_table()[row].cases, literal[row].cases) << literal[row].heads;
  }
}

TEST(SuitabilityClaims, ExtrudedMeshesAreRecognised) {
  EXPECT_EQ(extrusion_axis((*LastMesh(text_case("domain 4 5 6\n"))).mesh()), 0);
  EXPECT_EQ(extrusion_axis((*LastMesh(text_case("domain 4 4 4\nsubdivide 5/2 5/2 3/2\n"))).mesh()), std::nullopt);
  EXPECT_EQ(extrusion_axis((*LastMesh(text_case("domain 4 4 1\nsubdivide 5/2 5/2 1/2\n"))).mesh()), 2);
  EXPECT_EQ(extrusion_axis((*LastMesh(text_case("domain 4 1 4\nsubdivide 5/2 1/2 1/2\n"))).mesh()), 1);
}

/// Violations of a claim among all meshes that at most so many subdivisions make.
std::int64_t violations(const char* id, const PerAxis<int>& domain, int max_subdivisions) {
  std::int64_t count = 0;
  const Claim& claim = *find_claim(id);
  enumerate_meshes({{{3, 3, 3}, 2, domain}, max_subdivisions, false, true}, [&](const EnumeratedMesh& enumerated) {
    MeshUnderTest mesh(enumerated.tree);
    if (try_on_mesh(claim, mesh).verdict.outcome == Outcome::violated) count += enumerated.reflections;
  });
  return count;
}

// The findings' counterexamples are the smallest for m = 2, p = 3, 3, 3 by subdivisions, then by the domain's volume.
TEST(SuitabilityClaims, FewerSubdivisionsOrSmallerDomainsGiveNoCounterexample) {
  EXPECT_EQ(violations("as-implies-dc", {4, 4, 4}, 2), 0);
  EXPECT_EQ(violations("as-implies-dc", {4, 4, 5}, 1), 0);
  EXPECT_EQ(violations("as-implies-dc", {4, 4, 5}, 2), 8);
  EXPECT_EQ(violations("as-implies-dc", {5, 4, 4}, 2) + violations("as-implies-dc", {4, 5, 4}, 2), 0);
  for (const int longest : {4, 5, 6}) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      PerAxis<int> domain{4, 4, 4};
      domain[axis] = longest;
      EXPECT_EQ(violations("as-implies-dual-basis", domain, 2), 0);
    }
  }
  EXPECT_EQ(violations("as-implies-dual-basis", {5, 5, 4}, 1), 0);
  EXPECT_EQ(violations("as-implies-dual-basis", {5, 5, 4}, 2), 16);
  EXPECT_EQ(violations("dc-implies-as", {4, 4, 8}, 2), 0);
  EXPECT_EQ(violations("dc-implies-as", {5, 5, 8}, 2), 0);
}

/// Cases of all origins, small enough for the literal code.
RandomCase draw_case(Draw& draw, int number) {
  CaseLimits limits;
  limits.max_steps = 8;
  limits.max_elements = 250;
  if (number % 8 == 7) limits.max_degree = 5;
  if (number % 3 == 1) limits.max_side = 12;
  switch (number % 5) {
    case 0:
      return random_admissible_case(draw, limits);
    case 1:
      return random_trouble_case(draw, limits);
    case 2:
      return random_box_case(draw, limits);
    default:
      return random_bare_case(draw, limits);
  }
}

struct Seen {
  std::map<std::string, int> violated;
  int without_splines = 0;
  int with_quadruples = 0;
  int compatible_yet_touching = 0;
};

void compare(const Case& content, Seen& seen) {
  LastMesh mesh(content);
  constexpr std::size_t kNodesForQuadruples = 20;
  const auto literal = reference::decide_suitability_claims(literal::setting(setting_of(content)),
                                                            literal::last_mesh(content), kNodesForQuadruples);
  seen.without_splines += literal.verdicts.empty();
  for (const auto& [id, verdict] : literal.verdicts) {
    EXPECT_EQ(outcome(id.c_str(), *mesh), reference::verdict_name(verdict)) << id;
    seen.violated[id] += verdict == reference::Verdict::violated;
  }
  if (literal.verdicts.empty()) return;
  EXPECT_EQ(static_cast<std::size_t>(perturbed_means_no_overlap(*mesh).met), literal.lemma_met);
  EXPECT_EQ(!find_meeting_in_whole_domain(*mesh), literal.suitable_in_whole_domain);
  EXPECT_EQ(!find_incompatible_meeting((*mesh).splines(), (*mesh).bricks()), literal.meeting_pairs_overlap);
  EXPECT_EQ(literal.suitable_in_whole_domain, literal.meeting_pairs_overlap) << "the repaired theorem";
  seen.compatible_yet_touching += literal.compatible && !literal.meeting_pairs_overlap;
  if (!literal.verdicts.contains("case-table")) return;
  ++seen.with_quadruples;
  EXPECT_EQ(literal.compatible, literal.suitable_inside) << "the form that leaves dual-compatibility as it is";
}

class SuitabilityTwin : public testing::TestWithParam<int> {};

// The claims and their literal transcription give the same verdicts.
TEST_P(SuitabilityTwin, GivesTheSameVerdicts) {
  constexpr int kMeshes = 400;
  Draw draw(static_cast<std::uint64_t>(GetParam()) + 100);
  Seen seen;
  for (int i = 0; i < kMeshes && !testing::Test::HasFailure(); ++i) {
    const RandomCase random = draw_case(draw, i);
    SCOPED_TRACE(std::string(bias_name(random.bias)) + "\n" + write_case(random.content));
    compare(random.content, seen);
  }
  for (const auto& [id, count] : seen.violated) RecordProperty(id, count);
  RecordProperty("without-splines", seen.without_splines);
  RecordProperty("with-quadruples", seen.with_quadruples);
  RecordProperty("compatible-yet-touching", seen.compatible_yet_touching);
  EXPECT_GE(seen.with_quadruples, kMeshes / 5);
  EXPECT_GE(seen.violated["as-implies-dc"], 1);
}

INSTANTIATE_TEST_SUITE_P(Shards, SuitabilityTwin, testing::Range(0, 4));

// The literal code on the findings' cases, with all quadruples of nodes.
TEST(SuitabilityClaims, TwinAgreesOnTheFindings) {
  for (const char* id : {"as-implies-dc", "as-implies-dual-basis", "dc-implies-as"}) {
    const Case content = finding(id);
    LastMesh mesh(content);
    const auto literal =
        reference::decide_suitability_claims(literal::setting(setting_of(content)), literal::last_mesh(content), 40);
    ASSERT_TRUE(literal.verdicts.contains("case-table"));
    for (const auto& [claim, verdict] : literal.verdicts)
      EXPECT_EQ(outcome(claim.c_str(), *mesh), reference::verdict_name(verdict)) << claim;
    EXPECT_EQ(literal.compatible, literal.suitable_inside) << id;
  }
}

}  // namespace
}  // namespace asts
