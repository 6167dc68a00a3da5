#include "tests/reference/theorem_5_3_claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "properties/claims/second_patch.hpp"
#include "properties/claims/theorem_5_3_proof.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/properties/claim_checks.hpp"
#include "tests/properties/subdivided_mesh.hpp"

namespace asts {

namespace {

constexpr const char* kSetting = "degree 3 3 3\ngrading 2\n";

SubdividedMesh initial(const std::string& domain) { return SubdividedMesh(kSetting + ("domain " + domain + "\n")); }

Point point(const std::string& x, const std::string& y, const std::string& z) {
  return parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 99 99 99\nrefine " + x + " " + y + " " + z + "\n",
                    "f")
      .steps.front()
      .marks.front();
}

std::int64_t count(const std::vector<bool>& values) { return std::count(values.begin(), values.end(), true); }

Trial decide(const char* id, SubdividedMesh& subject) { return try_on_mesh(*find_claim(id), subject.mesh()); }

Outcome outcome(const char* id, SubdividedMesh& subject) { return decide(id, subject).verdict.outcome; }

// Degree 3 on 4 x 4 x 4: the only active node is (2,2,2). K = [1,2]^3 gets the face {3/2} x [1,2] x [1,2], whose corner
// (3/2, 2, 2) is outside the active region; (2,2,2) projects onto that corner.
TEST(Theorem53, SplitMissesTheCornersOfTheElement) {
  SubdividedMesh subject = initial("4 4 4");
  const SubdivisionStep step = subject.step_at(point("1", "1", "1"));
  ASSERT_EQ(step.faces.size(), 1U);
  EXPECT_EQ(step.faces[0].members, std::vector<bool>{false});
  EXPECT_EQ(step.faces[0].hatted_members, std::vector<bool>{true});
  EXPECT_EQ(step.is_new, std::vector<bool>{false});
  EXPECT_TRUE(judge_new_node_split(step).violation);
  EXPECT_FALSE(judge_new_node_split_repaired(step).violation);
  EXPECT_EQ(judge_new_node_split_repaired(step).met, 1);
}

// On 5 x 4 x 4 the active nodes are (2,2,2), (3,2,2); K = [2,3] x [1,2] x [1,2] adds (5/2,2,2) between them. All three
// are in N^_x(5/2), so that R^_x(5/2) is empty; Sigma is the point (5/2,2,2).
TEST(Theorem53, SmallestStepWithANewActiveNode) {
  SubdividedMesh subject = initial("5 4 4");
  const SubdivisionStep step = subject.step_at(point("2", "1", "1"));
  EXPECT_EQ(step.is_new, (std::vector<bool>{false, true, false}));
  EXPECT_EQ(count(step.faces.at(0).members), 0);
  EXPECT_EQ(count(step.faces.at(0).hatted_members), 3);
  EXPECT_EQ(count(step.faces.at(0).projected), 2);
  EXPECT_EQ(step.faces.at(0).sigma, (std::vector<Rectangle>{{{4, 4}, {4, 4}}}));  // half ranks of y = z = 2
  EXPECT_TRUE(step.hatted_regions[0].empty());
}

/// Degree 3 on 9 x 9 x 9, K = [4,5]^3: everything around it is inside the active region [2,7]^3.
SubdivisionStep middle_step() { return initial("9 9 9").step_at(point("4", "4", "4")); }

// The four new nodes (9/2, 4 or 5, 4 or 5) have the vectors (2,...,6) and (3,...,7): Sigma is {9/2} x [2,7] x [2,7],
// exactly the printed box nu +- eps (p+2) with nu = 9/2, eps = 1/2. The eight corners of K and the other eight old
// nodes (1 <= v_1 <= 7) with the corners' y and z project into the new face.
TEST(Theorem53, SigmaFillsThePrintedBox) {
  const SubdivisionStep step = middle_step();
  EXPECT_EQ(count(step.is_new), 4);
  EXPECT_EQ(count(step.faces.at(0).projected), 4 * 6);  // v_1 = 2, ..., 7
  UnionIntersection intersection;
  const auto& sigma = step.faces.at(0).sigma;
  EXPECT_EQ(intersection.of(sigma, sigma), (std::vector<Rectangle>{{{4, 4}, {14, 14}}}));
  EXPECT_FALSE(judge_sigma_extent(step).violation);
  EXPECT_GT(judge_sigma_extent(step).met, 0);
  EXPECT_TRUE(step.regions[0].empty());
  for (const Box& box : step.hatted_regions[0]) EXPECT_EQ(box.lower[0], 2 * step.faces[0].line);
}

TEST(Theorem53, ClaimsOnInitialMeshes) {
  for (const char* domain : {"4 4 4", "5 4 4", "6 5 4"}) {
    SubdividedMesh subject = initial(domain);
    EXPECT_EQ(outcome("new-node-split", subject), Outcome::violated);
    for (const char* id : {"admissible-implies-as", "new-nodes-keep-regions", "sigma-unperturbed",
                           "new-node-split-repaired", "second-patch-sizes", "sigma-extent"}) {
      EXPECT_EQ(outcome(id, subject), Outcome::holds) << id;
    }
  }
  SubdividedMesh empty = initial("3 4 4");
  EXPECT_EQ(outcome("new-node-split", empty), Outcome::not_applicable);
}

/// K = [3,4] x [2,3] x [1,2] cut along x, then its first half along y, with nothing else refined: not admissible, and
/// the perturbed regions of x and y meet.
const std::string kNotSuitable = std::string(kSetting) + "domain 6 6 4\nsubdivide 3 2 1\nsubdivide 3 2 1\n";

TEST(Theorem53, ClaimsDoNotApplyToOtherMeshes) {
  SubdividedMesh subject(kNotSuitable);
  for (const Claim& claim : theorem_5_3_claims()) {
    EXPECT_EQ(try_on_mesh(claim, subject.mesh()).verdict.outcome, Outcome::not_applicable) << claim.id;
  }
}

/// Domain 5 x 5 x 14, the element at (5/2, 5/2, 13/2) refined twice: levels 0 to 2 along z.
const std::string kGraded = std::string(kSetting) + "domain 5 5 14\nrefine 5/2 5/2 13/2\nrefine 5/2 5/2 13/2\n";

// A graded mesh meets every hypothesis.
TEST(Theorem53, ClaimsOnAGradedMesh) {
  SubdividedMesh subject(kGraded);
  EXPECT_GT(decide("admissible-implies-as", subject).met, 0);
  for (const Claim& claim : theorem_5_3_claims()) {
    const Trial trial = try_on_mesh(claim, subject.mesh());
    EXPECT_EQ(trial.verdict.outcome, claim.refuted ? Outcome::violated : Outcome::holds) << claim.id;
    EXPECT_GT(trial.met, 0) << claim.id;
  }
}

Verdict verdict_of(Judgement judgement) {
  return judgement.violation ? Verdict::violated(std::move(*judgement.violation)) : Verdict::holds();
}

Verdict without_new_lines() {
  SubdivisionStep step = middle_step();
  step.faces.clear();
  return verdict_of(judge_kept_regions(step));
}

Verdict with_wrong_axis() {
  SubdivisionStep step = middle_step();
  step.hatted_regions[at(step.role(1))] = step.hatted_regions[at(step.role(0))];
  return verdict_of(judge_sigma_unperturbed(step));
}

/// [1,2] x [2,3] x [1,2] was subdivided before K = [1,2]^3: the line (., 2, 2) has 3/2 from the closed face already.
SubdivisionStep second_of_two_neighbours() {
  return SubdividedMesh(std::string(kSetting) + "domain 4 4 4\nsubdivide 1 2 1\n").step_at(point("1", "1", "1"));
}

Verdict with_open_old_faces() {
  SubdivisionStep step = second_of_two_neighbours();
  step.faces.at(0).members.assign(step.faces[0].members.size(), false);
  return verdict_of(judge_new_node_split(step));
}

Verdict with_open_rectangle() {
  SubdivisionStep step = middle_step();
  step.faces.at(0).projected.assign(step.faces[0].projected.size(), false);
  return verdict_of(judge_new_node_split_repaired(step));
}

Verdict with_sizes_along_the_next_axis() {
  SubdividedMesh subject(kGraded);
  PatchElements all = patch_elements(subject.tree());
  for (PatchElements::Element& element : all.elements) {
    std::rotate(element.size.begin(), element.size.begin() + 1, element.size.end());
  }
  for (std::size_t i = 0; i < all.elements.size(); ++i) {
    Judgement judgement = judge_second_patch(subject.tree(), all, i);
    if (judgement.violation) return verdict_of(std::move(judgement));
  }
  return Verdict::holds();
}

Verdict with_lower_degree() {
  SubdivisionStep step = middle_step();
  step.mesh.setting.degree[at(step.role(1))] -= 2;
  return verdict_of(judge_sigma_extent(step));
}

Verdict without_admissibility() {
  SubdividedMesh subject(kNotSuitable);
  return regions_apart(subject.mesh()).verdict;
}

// Without the planted faults nothing is wrong.
TEST(Theorem53, ControlsHoldWithoutTheirFaults) {
  const SubdivisionStep step = middle_step();
  EXPECT_FALSE(judge_kept_regions(step).violation);
  EXPECT_FALSE(judge_sigma_unperturbed(step).violation);
  EXPECT_FALSE(judge_new_node_split(second_of_two_neighbours()).violation);
  EXPECT_FALSE(judge_new_node_split_repaired(step).violation);
  EXPECT_FALSE(judge_sigma_extent(step).violation);
}

}  // namespace

std::vector<NegativeControl> theorem_5_3_controls() {
  return {{"admissible-implies-as", "the hypothesis forgotten", without_admissibility},
          {"new-nodes-keep-regions", "the new slices not left out", without_new_lines},
          {"sigma-unperturbed", "the region of x taken for that of y", with_wrong_axis},
          {"new-node-split", "the old mesh's closed faces taken as open", with_open_old_faces},
          {"new-node-split-repaired", "the new closed face taken as open", with_open_rectangle},
          {"second-patch-sizes", "sizes read off the next axis", with_sizes_along_the_next_axis},
          {"sigma-extent", "the degree lower by two", with_lower_degree}};
}

std::vector<Confirmation> theorem_5_3_confirmations() {
  return {{"new-node-split", [](const Case& counterexample) {
             return reference::refutes_new_node_split(literal::setting(setting_of(counterexample)),
                                                      literal::last_mesh(counterexample));
           }}};
}

}  // namespace asts
