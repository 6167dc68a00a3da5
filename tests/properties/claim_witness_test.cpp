#include <gtest/gtest.h>

#include "lib/mesh/case_file.hpp"
#include "tests/properties/claim_witness_checks.hpp"

// The witnesses of the claims of Sections 2, 3, 7, Appendix A and Proposition 6.1, as the program writes them, before
// the literal code: those of refuted claims are valid, and those made under planted faults are not.
namespace asts::witness_checks {
namespace {

using nlohmann::json;

Case parsed(const std::string& text) { return parse_case("asts-case 1\n" + text, "case"); }

std::string repeated(const std::string& line, int times) {
  std::string text;
  for (; times > 0; --times) text += line + "\n";
  return text;
}

void expect_mentions(const std::string& report, std::initializer_list<const char*> words) {
  for (const char* word : words) EXPECT_NE(report.find(word), std::string::npos) << word << " in: " << report;
}

void expect_valid(const char* claim, std::initializer_list<const char*> numbers) {
  const Case content = finding(claim);
  const reference::Validation result = validated(content, claim, witness_of(claim, content));
  EXPECT_TRUE(result.valid) << claim << ": " << result.report;
  expect_mentions(result.report, numbers);
}

TEST(ClaimWitness, OfRefutedClaimsAreValidAndGiveBothSides) {
  expect_valid("child-distance", {"m = 3", "[0, 1/3] x [0, 1] x [0, 1] is child 1", "(1/3, 0, 0)", "(1/9, 0, 0)"});
  expect_valid("child-distance-bound", {"m = 3", "1/3, more than 1/9"});
  expect_valid("experiment-constant", {"m = 3", "186805 new elements for 117 marks", "186805/117", "1595.968265"});
}

// The meshes have 1316 and 6e7 elements.
TEST(ClaimWitness, OfRefutedBoundsForLargeGradingsAreValid) {
  expect_valid("distance-bound", {"K_0 = [1, 2] x [0, 1] x [0, 1] of level 0", "1318/1315", "1.002223"});
  expect_valid("lambda-sums", {"1307 marks", "[3908/1303, 3] x [0, 1] x [0, 1] of level 1", "1302/1303 < 1"});
}

TEST(ClaimWitness, OfStatementsThatNeedNoMeshAreValidByTheirNumbers) {
  for (const char* claim : {"child-distance", "child-distance-bound", "experiment-constant"}) {
    const json witness = json_of(try_alone(*find_claim(claim), Extent::short_run).verdict);
    const reference::Validation result = validated_alone(claim, witness);
    EXPECT_TRUE(result.valid) << claim << ": " << result.report;
    const reference::Validation on_cube = validated(parsed("degree 3 3 3\ngrading 2\ndomain 1 1 1\n"), claim, witness);
    EXPECT_FALSE(on_cube.valid) << claim << ": " << on_cube.report;
  }
}

/// A planted fault, the mesh that its witness is about ("" for none), and what the literal code says against it.
struct Planted {
  const char* claim;
  const char* fault;
  std::string content;
  const char* reason;
};

void expect_rejected(const std::vector<NegativeControl>& controls, const std::vector<Planted>& faults) {
  EXPECT_EQ(controls.size(), faults.size()) << "each control has its rejection";
  for (const Planted& fault : faults) {
    const json witness = planted(controls, fault.claim, fault.fault);
    const reference::Validation result = fault.content.empty() ? validated_alone(fault.claim, witness)
                                                               : validated(parsed(fault.content), fault.claim, witness);
    EXPECT_FALSE(result.valid) << fault.claim << ": " << fault.fault;
    EXPECT_NE(result.report.find(fault.reason), std::string::npos)
        << fault.claim << ": " << fault.fault << ": " << result.report << "\n"
        << witness.dump();
  }
}

std::string long_corner(int steps) {
  return "degree 3 3 3\ngrading 2\ndomain 16 2 2\n" + repeated("refine 0 0 0", steps);
}

std::string bare_corner(int steps) {
  return "degree 3 3 3\ngrading 2\ndomain 6 2 2\n" + repeated("subdivide 0 0 0", steps);
}

TEST(ClaimWitness, OfFaultsPlantedIntoSections2And3AreRejected) {
  const std::string example = "degree 3 3 3\ngrading 16\ndomain 4 5 8\n" + repeated("refine 0 0 0", 3);
  expect_rejected(
      refinement_controls(),
      {{"example-table", "patches of degree 5", example, "the number of new elements is 1030, not"},
       {"closure-least", "one pass instead of as many as the set grows", long_corner(5), "is in both"},
       {"closure-least", "closed for open environments", long_corner(5), "is in neither"},
       {"closure-least", "elements of the same level too", long_corner(2), "is in neither"},
       {"subdivision-commutes", "a call of refine for each element instead of its subdivision", bare_corner(4),
        "make the same mesh of"},
       {"patch-shrinks-with-grading", "the cases k = 1 and k = 2 mod 3 mixed up", "", "D(k) along the axis is"},
       {"patch-shrinks-with-grading", "a radius that does not depend on m", "", "D(k) along the axis is"},
       {"refine-admissible", "the closure forgotten", long_corner(2), "coarser: "},
       {"refine-admissible", "one pass instead of as many as the set grows", long_corner(5), "coarser: "},
       {"refine-generates-class", "a closure with elements of the same level", long_corner(3), "elements after is"},
       {"refine-generates-class", "the mesh is not admissible", bare_corner(2), "the mesh is not admissible"},
       {"patches-nested", "a level off by one: the environment of an element's first child", long_corner(5),
        "the element is in the patch of outer"},
       {"levels-change-slowly", "closed for open environments", long_corner(5), "does not meet the open environment"},
       {"levels-change-slowly", "the mesh is not admissible", bare_corner(2), "the mesh is not admissible"},
       {"level-order-replay", "closed for open environments", long_corner(5), "does not meet the open environment"},
       {"overlay-admissible", "a common refinement that is not the coarsest: one element cut once more", long_corner(2),
        "element: "},
       {"overlay-cardinality", "a common refinement that is not the coarsest: one element cut once more",
        long_corner(1), "elements of G1 (+) G2 is"}});
}

TEST(ClaimWitness, OfFaultsPlantedIntoAppendixAAreRejected) {
  expect_rejected(
      equation_controls(),
      {{"size-formula", "the axes x and y exchanged", "", "K: subdivisions of [0,1]^3 do not make it"},
       {"child-distance", "a child counted from 1", "", "K: subdivisions of [0,1]^3 do not make it"},
       {"child-distance-repaired", "a child counted from 1", "", "K: subdivisions of [0,1]^3 do not make it"},
       {"patch-radius-step", "the child's level one too high", "", "K: its level is 4"},
       {"radius-bounds", "m^(1/3) forgotten in the second component", "degree 3 3 3\ngrading 16\ndomain 2 12 1\n",
        "the bound is"},
       {"child-distance-bound", "a child counted from 1", "", "K: subdivisions of [0,1]^3 do not make it"},
       {"child-distance-bound-repaired", "a child counted from 1", "", "K: subdivisions of [0,1]^3 do not make it"}});
}

TEST(ClaimWitness, OfFaultsPlantedIntoSection7AreRejected) {
  const std::string row = "degree 3 3 3\ngrading 2\ndomain 16 1 1\n" + repeated("refine 0 0 0", 5);
  const std::string corner = "degree 3 3 3\ngrading 3\ndomain 5 5 5\n";
  const std::string chain = write_case(finding("lambda-sums")).substr(std::string("asts-case 1\n").size());
  expect_rejected(
      complexity_controls(),
      {{"distance-bound", "the factor 1/(1 - m^(-1/3)) forgotten", row, "the bound is"},
       {"distance-bound-repaired", "the factor 1/(1 - m^(-1/3)) forgotten", row, "the bound is"},
       {"complexity-bound", "C without the distances d", corner + repeated("refine 0 0 0", 9), "C times marks is"},
       {"lambda-sums", "lambda with 2d = (1,1,1)", corner + repeated("refine 0 0 0", 6),
        "the number of marks with lambda(K,K~) > 0 is"},
       {"lambda-sums-repaired", "the printed constants for m = 1303", chain,
        "the number of marks with lambda(K,K~) > 0 is"},
       {"experiment-constant", "late steps' growth counted one and a half times", "", "the limit of the ratio is 924"},
       {"experiment-constant-repaired", "old elements counted as new", "", "the ratio is below the bound"}});
}

TEST(ClaimWitness, OfFaultsPlantedIntoProposition61AreRejected) {
  expect_rejected(
      functional_controls(),
      {{"perfect-bspline", "the factor p in the place of p+1", "", "the integral is 1, not as printed"},
       {"perfect-bspline", "the sign (-1)^(p+1) forgotten", "", "B* is positive between y_"},
       {"perfect-bspline", "y_0 left out of the divided difference", "", "D^(p+1)(G phi) is not zero"},
       {"overlap-duality", "the index vector of the functional shifted by one entry", "", "lambda_X(N_X~) is "}});
}

}  // namespace
}  // namespace asts::witness_checks
