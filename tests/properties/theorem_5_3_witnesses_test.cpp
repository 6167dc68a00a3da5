#include "lib/gen/random_case.hpp"
#include "tests/properties/claim_witnesses.hpp"

namespace asts {
namespace {

Case text_case(const std::string& text) { return parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\n" + text, "case"); }

TEST(Theorem53Witnesses, OfTheFindingIsValid) {
  expect_valid("new-node-split", finding_case("new-node-split"),
               {"The mesh is admissible", "The mesh is analysis-suitable", "K = [0, 1] x [1, 2] x [1, 2]", "(2, 2, 2)",
                "is not in N_x(1/2) before the step", "is in N_x(1/2) after the step"});
}

TEST(Theorem53Witnesses, OfRandomMeshesAreValid) {
  CaseLimits limits;
  limits.max_cubes = 110;
  limits.max_elements = 130;
  Draw draw(5);
  int violated = 0;
  for (int round = 0; round < 60; ++round) {
    const RandomCase random = random_admissible_case(draw, limits);
    const nlohmann::json witness = witness_of("new-node-split", random.content);
    if (witness.is_null()) continue;
    ++violated;
    const reference::Validation result = validated(random.content, "new-node-split", witness);
    ASSERT_TRUE(result.valid) << result.report << "\n" << write_case(random.content) << witness.dump(1);
    EXPECT_FALSE(validated(random.content, "new-node-split-repaired", witness).valid) << write_case(random.content);
  }
  EXPECT_GE(violated, 40);
}

TEST(Theorem53Witnesses, Corrupted) {
  const Case content = text_case("domain 4 4 4\n");
  const nlohmann::json witness = witness_of("new-node-split", content);
  expect_rejected("new-node-split", content, witness,
                  {{"/values/element/upper/1", "\"3\"", "is no element of the mesh"},
                   {"/values/element/level", "1", "its level is 0, not as printed"},
                   {"/values/element/level", "null", "its level is 0, not as printed"},
                   {"/values/xi", "\"5/3\"", "is no coordinate of the mesh"},
                   {"/values/xi", "\"1\"", "is no coordinate of a new face"},
                   {"/values/xi", "\"6/4\"", "not a number in lowest terms"},
                   {"/values/node/node/0", "\"3/2\"", "is no node of the mesh"},
                   {"/values/node/node/0", "\"1\"", "is not in the active region"},
                   {"/values/node/index_vectors/x", "[\"0\",\"1\",\"2\",\"3\",\"4\"]", "its index vector along x is"},
                   {"/values/new", "\"yes\"", "new is no"},
                   {"/values/new", "false", "new is neither"},
                   {"/values/in_slice_before", "\"yes\"", "in_slice_before is no"},
                   {"/values/in_slice_after", "\"no\"", "in_slice_after is yes"},
                   {"/values/in_slice_after", "", "lacks the key \"in_slice_after\""}});
  EXPECT_EQ(validated(content, "new-node-split-repaired", witness).report,
            "nothing is violated: the split says what is true of the node");
}

// A mesh for which a hypothesis fails: not admissible, not analysis-suitable, or a step that is not admissible.
TEST(Theorem53Witnesses, WhoseHypothesisFails) {
  const nlohmann::json witness = witness_of("new-node-split", text_case("domain 4 4 4\n"));
  const auto report = [&](const std::string& text) {
    return validated(text_case(text), "new-node-split", witness).report;
  };
  EXPECT_EQ(report("domain 9 9 9\nsubdivide 5 5 5\nsubdivide 5 5 5\n"),
            "the mesh is not admissible: the claim says nothing about it");
  nlohmann::json child = witness;
  child["values"]["element"] = nlohmann::json::parse(R"({"lower":["0","0","0"],"upper":["1/2","1","1"],"level":1})");
  EXPECT_EQ(validated(text_case("domain 4 4 4\nsubdivide 0 0 0\n"), "new-node-split", child).report,
            "the subdivision of the element is not admissible");
}

// The faults of tests/properties/theorem_5_3_claims_test.cpp, in the meshes that they are planted in.
TEST(Theorem53Witnesses, OfPlantedFaultsAreRejected) {
  const Case middle = text_case("domain 9 9 9\n");
  const Case neighbours = text_case("domain 4 4 4\nsubdivide 1 2 1\n");
  const Case graded = text_case("domain 5 5 14\nrefine 5/2 5/2 13/2\nrefine 5/2 5/2 13/2\n");
  const Case crossing = text_case("domain 6 6 4\nsubdivide 3 2 1\nsubdivide 3 2 1\n");
  expect_planted_rejected(
      theorem_5_3_controls(),
      {{"admissible-implies-as", "the hypothesis forgotten", crossing, "the mesh is not admissible"},
       {"new-nodes-keep-regions", "the new slices not left out", middle, "in one of the new slices"},
       {"sigma-unperturbed", "the region of x taken for that of y", middle, "not in the perturbed region of y"},
       {"new-node-split", "the old mesh's closed faces taken as open", neighbours, "in_slice_before is yes"},
       {"new-node-split-repaired", "the new closed face taken as open", middle, "the split says what is true"},
       {"second-patch-sizes", "sizes read off the next axis", graded, ""},
       {"sigma-extent", "the degree lower by two", middle, "nothing is violated"}});
}

/// A witness with values that are written by hand.
std::string report_of(const std::string& claim, const Case& content, const char* kind, const char* values) {
  for (const reference::ClaimKind& form : reference::all_claim_kinds()) {
    if (claim != form.claim || std::string(kind) != form.kind) continue;
    return validated(content, claim, {{"kind", kind}, {"says", form.says}, {"values", nlohmann::json::parse(values)}})
        .report;
  }
  return "no such form";
}

// K = [4,5]^3 in 9^3: Sigma is {9/2} x [2,7] x [2,7], its box is the same, and all of N_A meets it.
TEST(Theorem53Witnesses, ThatNoMeshHas) {
  const Case middle = text_case("domain 9 9 9\n");
#define ELEMENT R"("element":{"lower":["4","4","4"],"upper":["5","5","5"],"level":0},"xi":"9/2",)"
  EXPECT_EQ(report_of("new-node-split-repaired", middle, "larger-sigma", "{" ELEMENT R"("point":["9/2","2","7"]})"),
            "the point is in Sigma");
  EXPECT_EQ(report_of("new-node-split-repaired", middle, "larger-sigma", "{" ELEMENT R"("point":["5","2","7"]})"),
            "the point is not in the slice at xi");
  EXPECT_EQ(report_of("new-node-split-repaired", middle, "outside-old-region-and-sigma",
                      "{" ELEMENT R"("point":["9/2","1","1"]})"),
            "the point is not in the slice perturbation after the step");
  EXPECT_EQ(report_of("sigma-extent", middle, "sigma-too-large",
                      "{" ELEMENT R"("part":{"lower":["9/2","2","2"],"upper":["9/2","7","7"]}})"),
            "nothing is violated: the part lies in the box that is said to contain Sigma");
  EXPECT_EQ(report_of("sigma-extent", middle, "sigma-too-large",
                      "{" ELEMENT R"("part":{"lower":["9/2","1","2"],"upper":["9/2","7","7"]}})"),
            "part: it is no part of Sigma");
#undef ELEMENT
}

}  // namespace
}  // namespace asts
