#include "tests/reference/independence_claims.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <iostream>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "lib/spline/independence.hpp"
#include "properties/claims/independence.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/properties/claim_checks.hpp"
#include "tests/reference/suitability.hpp"

namespace asts {
namespace {

void with_mesh(const Case& content, const std::function<void(MeshUnderTest&)>& test) {
  if (content.explicit_mesh) {
    MeshUnderTest mesh(mesh_of(setting_of(content), content.elements));
    return test(mesh);
  }
  Replay replay(content);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  test(mesh);
}

Case case_of(const std::string& text) { return parse_case("asts-case 1\n" + text, "f"); }

Trial decided(const Case& content) {
  Trial trial;
  with_mesh(content, [&](MeshUnderTest& mesh) { trial = try_on_mesh(*find_claim("dc-implies-independent"), mesh); });
  return trial;
}

/// Two nodes with the same three index vectors: the second one's along x is shifted by one entry.
Verdict run_shifted_vector() {
  Verdict verdict;
  with_mesh(case_of("degree 3 3 3\ngrading 2\ndomain 6 5 4\n"), [&](MeshUnderTest& mesh) {
    TSplines splines = mesh.splines();
    splines.vector_ids[at(splines.size()) - 1][0] = splines.vector_ids[0][0];
    verdict = judge_independence(mesh.mesh(), splines);
  });
  return verdict;
}

// 7 x 5 x 4 unit cubes: 4 x 2 x 1 active nodes, all in one tensor product.
TEST(IndependenceClaim, HoldsOnATensorProductWithoutMeetingAnything) {
  const Trial trial = decided(case_of("degree 3 3 3\ngrading 2\ndomain 7 5 4\n"));
  EXPECT_EQ(trial.verdict.outcome, Outcome::holds);
  EXPECT_EQ(trial.met, 0);
}

// [2,3]^3 cut at x = 5/2: x-vectors on the four lines through the cut have 5/2, those on the others have not.
TEST(IndependenceClaim, IsMetWhereIndexVectorsDiffer) {
  const Trial trial = decided(case_of("degree 3 3 3\ngrading 2\ndomain 6 6 5\nsubdivide 2 2 2\n"));
  EXPECT_EQ(trial.verdict.outcome, Outcome::holds);
  EXPECT_GE(trial.met, 1);
}

TEST(IndependenceClaim, SaysNothingWithoutItsHypothesis) {
  const Case bad = read_case_file(std::string(ASTS_CASES) + "/planar/published-bad-tmesh.case");
  EXPECT_EQ(decided(bad).verdict.outcome, Outcome::not_applicable);
  EXPECT_EQ(decided(case_of("degree 3 3 3\ngrading 2\ndomain 3 4 4\n")).verdict.outcome, Outcome::not_applicable);
}

// 17^3 active nodes are too many for an elimination: that decides nothing.
TEST(IndependenceClaim, IsUndecidedForTooManyNodes) {
  EXPECT_EQ(decided(case_of("degree 3 3 3\ngrading 2\ndomain 20 20 20\n")).verdict.outcome, Outcome::undecided);
}

// A published planar T-mesh that is not analysis-suitable, and still its blending functions are independent: the
// converse of the corollary is false.
TEST(IndependenceClaim, ConverseIsFalse) {
  const Case bad = read_case_file(std::string(ASTS_CASES) + "/planar/published-bad-tmesh.case");
  with_mesh(bad, [](MeshUnderTest& mesh) {
    EXPECT_EQ(judge_independence(mesh.mesh(), mesh.splines()).outcome, Outcome::holds);
  });
}

TEST(IndependenceClaim, ReportsTheCombination) {
  const Verdict verdict = run_shifted_vector();
  ASSERT_TRUE(verdict.witness);
  const auto& witness = std::get<ClaimWitness>(*verdict.witness);
  EXPECT_EQ(witness.kind, "dependent");
  ASSERT_EQ(witness.values.size(), 4U) << "two coefficients, two nodes";
  EXPECT_EQ(std::get<Rational>(witness.values[0].second), 1);
  EXPECT_EQ(std::get<Rational>(witness.values[2].second), -1);
}

struct Tally {
  int meshes = 0;
  int dual_compatible = 0;
  int met = 0;                    ///< of these, with pairs that count
  int active_region_only = 0;     ///< independent, but not on the active region
  int active_region_checked = 0;  ///< where it has a volume
};

bool has_volume(const ActiveRegion& region) {
  bool volume = !region.empty;
  for (std::size_t a = 0; a < kDimension; ++a) volume = volume && region.lower[a] < region.upper[a];
  return volume;
}

/// The claim's verdict, and its conclusion on every mesh, against the Gram matrix of the literal blending functions.
void compare(const Case& content, Tally& tally) {
  const auto literal_mesh = literal::last_mesh(content);
  const auto space = reference::make_space<Rational>(literal::setting(setting_of(content)), literal_mesh, 1);
  const auto splines = reference::active_splines(space);
  const Trial trial = decided(content);
  if (!splines || splines->empty()) {
    EXPECT_EQ(trial.verdict.outcome, Outcome::not_applicable);
    return;
  }
  if (splines->size() > 40) return;
  const bool dual_compatible = !reference::not_dual_compatible(*splines);
  const bool independent = reference::rank_of_blending_functions(*splines) == splines->size();
  const Outcome conclusion = independent ? Outcome::holds : Outcome::violated;
  EXPECT_EQ(trial.verdict.outcome, dual_compatible ? conclusion : Outcome::not_applicable);
  ++tally.meshes;
  tally.dual_compatible += dual_compatible;
  tally.met += trial.met > 0;
  with_mesh(content, [&](MeshUnderTest& mesh) {
    EXPECT_EQ(judge_independence(mesh.mesh(), mesh.splines()).outcome, conclusion);
    if (!has_volume(mesh.splines().region)) return;
    ++tally.active_region_checked;
    tally.active_region_only += !certainly_independent(mesh.mesh(), mesh.splines(), Region::active_region);
  });
}

RandomCase draw_case(Draw& draw, const CaseLimits& limits) {
  const int origin = draw.between(0, 5);
  if (origin == 0) return random_admissible_case(draw, limits);
  return origin <= 2 ? random_bare_case(draw, limits) : random_box_case(draw, limits);
}

TEST(IndependenceClaim, AgreesWithTheLiteralCodeOnRandomMeshes) {
  Draw draw(23);
  CaseLimits limits;
  Tally tally;
  for (int round = 0; round < 900 && !testing::Test::HasFailure(); ++round) {
    limits.max_cubes = draw.one_in(5) ? 150 : 110;  // 5 x 5 x 5 and more: the active region has a volume
    limits.max_elements = 180;
    const RandomCase random = draw_case(draw, limits);
    SCOPED_TRACE(std::string(bias_name(random.bias)) + "\n" + write_case(random.content));
    compare(random.content, tally);
  }
  std::cout << "meshes: " << tally.meshes << "\ndual-compatible: " << tally.dual_compatible << "\nmet: " << tally.met
            << "\nactive regions with volume: " << tally.active_region_checked
            << "\ndependent there alone: " << tally.active_region_only << '\n';
  EXPECT_GE(tally.dual_compatible, 300);
  EXPECT_GE(tally.met, 100);
  EXPECT_GE(tally.meshes - tally.dual_compatible, 50) << "without the hypothesis";
}

}  // namespace

std::vector<NegativeControl> independence_controls() {
  return {{"dc-implies-independent", "an index vector shifted by one entry", run_shifted_vector}};
}

std::vector<Confirmation> independence_confirmations() { return {}; }

}  // namespace asts
