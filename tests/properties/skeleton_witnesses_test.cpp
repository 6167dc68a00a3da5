#include <map>

#include "lib/gen/random_case.hpp"
#include "properties/claims/proof_figure.hpp"
#include "tests/properties/claim_witnesses.hpp"

namespace asts {
namespace {

Case text_case(const std::string& text) { return parse_case("asts-case 1\n" + text, "case"); }

TEST(SkeletonWitnesses, OfTheFindingsAreValid) {
  expect_valid("frame-in-index-sets", finding_case("frame-in-index-sets"),
               {"The mesh is admissible", "the degree is 5 and the domain 1 long", "is (0, 1), without it"});
  expect_valid(
      "perturbed-cover-hanging", finding_case("perturbed-cover-hanging"),
      {"It is not uniform", "hangs along x on the element [0, 1] x ", "is in none of the three perturbed regions"});
  expect_valid("perturbed-cover-hanging", finding_case("perturbed-cover-hanging-inside"),
               {"hangs along x on the element", "is in none of the three perturbed regions"});
  expect_valid("planar-equals-classical", finding_case("planar-equals-classical"),
               {"the mesh is planar, extruded along z", "The mesh is analysis-suitable"});
}

TEST(SkeletonWitnesses, OfTheProofsFigureAreValid) {
  expect_valid("figure-proof-levels", finding_case("figure-proof-levels"),
               {"through the middle of K = [2, 5/2] x [10, 21/2] x [25/2, 13]", "the mesh is not admissible",
                "patch: ", "second-order patch: "});
}

// The table of reports/findings/figure-proof-levels.md for the degrees 3 and 5, found by the literal code.
TEST(SkeletonWitnesses, ThatNoDegreeFitsIsValid) {
  const nlohmann::json witness = json_of(try_alone(*find_claim("figure-proof-levels"), Extent::short_run).verdict);
  const Case any = finding_case("new-node-split");
  const reference::Validation result = validated(any, "figure-proof-levels", witness);
  EXPECT_TRUE(result.valid) << result.report << witness;
  EXPECT_NE(result.report.find("Ry: (3,3) (5,3)"), std::string::npos) << result.report;
  expect_rejected("figure-proof-levels", any, witness,
                  {{"/values/tried to", "11", "only degrees from 3 to 9"},
                   {"/values/levels", "\"(3,3)\"", "levels: as drawn for none"},
                   {"/values/patch", "", "lacks the key \"patch\""}});
}

TEST(SkeletonWitnesses, OfRandomMeshesAreValid) {
  CaseLimits limits;
  limits.max_degree = 5;
  limits.max_cubes = 60;
  limits.max_elements = 110;
  std::map<std::string, int> violated;
  Draw draw(3);
  for (int round = 0; round < 150; ++round) {
    const RandomCase random = draw.one_in(2) ? random_admissible_case(draw, limits) : random_bare_case(draw, limits);
    for (const char* id : {"frame-in-index-sets", "perturbed-cover-hanging"}) {
      const nlohmann::json witness = witness_of(id, random.content);
      if (witness.is_null()) continue;
      ++violated[witness["kind"].get<std::string>()];
      const reference::Validation result = validated(random.content, id, witness);
      ASSERT_TRUE(result.valid) << id << ": " << result.report << "\n" << write_case(random.content) << witness.dump(1);
    }
  }
  EXPECT_GE(violated["hanging-node-not-covered"], 60);
}

TEST(SkeletonWitnesses, CorruptedEntry) {
  const Case content = text_case("degree 5 3 3\ngrading 2\ndomain 1 1 1\n");
  const nlohmann::json witness = witness_of("frame-in-index-sets", content);
  expect_rejected("frame-in-index-sets", content, witness,
                  {{"/values/axis", "\"w\"", "not a axis"},
                   {"/values/axis", "\"y\"", "degree: it is 3"},
                   {"/values/point/1", "\"2\"", "not in the domain"},
                   {"/values/point/0", "\"1\"", "not written as 0"},
                   {"/values/length", "2", "length: it is 1"},
                   {"/values/degree", "3", "degree: it is 5"},
                   {"/values/entry", "\"1\"", "nothing is violated: the index set has the entry 1"},
                   {"/values/entry", "\"7\"", "none that the note names"},
                   {"/values/index_set", "[\"0\",\"1\",\"2\"]", "index_set: it is (0, 1)"},
                   {"/values/index_set", "\"0\"", "not a list of numbers"}});
  EXPECT_EQ(validated(content, "frame-in-index-sets-repaired", witness).report,
            "the domain is too short along the axis: nothing is said of it");
  const Case bare = text_case("degree 5 3 3\ngrading 2\ndomain 9 9 9\nsubdivide 5 5 5\nsubdivide 5 5 5\n");
  EXPECT_EQ(validated(bare, "frame-in-index-sets", witness).report,
            "the mesh is not admissible: the claim says nothing about it");
}

TEST(SkeletonWitnesses, CorruptedHangingNode) {
  const Case content = text_case("degree 3 3 3\ngrading 2\ndomain 1 2 1\nsubdivide 1/2 1/2 1/2\n");
  const nlohmann::json witness = witness_of("perturbed-cover-hanging", content);
  expect_rejected(
      "perturbed-cover-hanging", content, witness,
      {{"/kind", "\"hanging-edge-not-covered\"", "hanging: it is a point"},
       {"/values/axis", "\"y\"", "slice: the node or edge is not in it"},
       {"/values/slice", "\"1/3\"", "slice: the node or edge is not in it"},
       {"/values/hanging", R"({"lower":["1/3","1","0"],"upper":["1/3","1","0"]})", "is no node of the mesh"},
       {"/values/hanging", R"({"lower":["0","1","0"],"upper":["0","1","0"]})", "does not hang on the element"},
       {"/values/element", R"({"lower":["0","0","0"],"upper":["1","1","1"],"level":0})", "is no element"},
       {"/values/element/level", "3", "its level is 0"},
       {"/values/point/2", "\"1/2\"", "not on the node or edge"}});
  EXPECT_EQ(validated(text_case("degree 3 3 3\ngrading 2\ndomain 1 2 1\n"), "perturbed-cover-hanging", witness).report,
            "the mesh is uniform: the claim says nothing about it");
}

TEST(SkeletonWitnesses, CorruptedExtensions) {
  const Case content = finding_case("planar-equals-classical");
  const nlohmann::json witness = witness_of("planar-equals-classical", content);
  expect_rejected(
      "planar-equals-classical", content, witness,
      {{"/values/extruded_along", "\"x\"", "not extruded along x"},
       {"/values/horizontal_junction/0", "\"2\"", "is no T-junction"},
       {"/values/horizontal_extension/upper/0", "\"6\"", "is not that of the junction"},
       {"/values/vertical_extension/lower/2", "\"1\"", "not written as 0"},
       {"/values/vertical_junction", witness["values"]["horizontal_junction"].dump().c_str(), "is no T-junction"}});
  EXPECT_EQ(validated(content, "planar-equals-classical-repaired", witness).report,
            "two T-junctions face each other across one element: the claim says nothing about the mesh");
}

TEST(SkeletonWitnesses, CorruptedFigure) {
  const Case content = finding_case("figure-proof-levels");
  const nlohmann::json witness = witness_of("figure-proof-levels", content);
  expect_rejected("figure-proof-levels", content, witness,
                  {{"/values/K/level", "2", "K: its level is 3"},
                   {"/values/K/upper/0", "\"3\"", "not the element of level 3"},
                   {"/values/patch", "[\"8\",\"11\"]", "which both figure and mesh have"},
                   {"/values/patch", "[\"-1\",\"11\"]", "not in the drawn squares"},
                   {"/values/Sigma", "[\"8\",\"11\"]", "nothing is violated"},
                   {"/values/levels: coarser", "", "lacks the key"},
                   {"/values/levels: coarser/level", "3", "its level is"},
                   {"/values/another", "1", "none of its kind"}});
  EXPECT_EQ(validated(finding_case("new-node-split"), "figure-proof-levels", witness).report,
            "the setting is not the figure's: the claim says nothing about the mesh");
}

// The faults of tests/properties/skeleton_claims_test.cpp: none of these meshes violates the claim.
TEST(SkeletonWitnesses, OfPlantedFaultsAreRejected) {
  const Case middle = text_case("degree 3 3 3\ngrading 2\ndomain 9 9 9\nsubdivide 4 4 4\n");
  const Case frame = text_case("degree 5 3 3\ngrading 2\ndomain 6 4 4\n");
  const Case bad = read_case_file(std::string(ASTS_CASES) + "/planar/published-bad-tmesh.case");
  const char* const merged = "two boxes of the frame merged";
  const char* const lower = "extensions of a degree that is lower by two";
  expect_planted_rejected(
      skeleton_controls(),
      {{"frame-in-index-sets", merged, frame, "index_set: it is (0, 1, 2, 3, 4, 5, 6)"},
       {"frame-in-index-sets-repaired", merged, frame, "index_set: it is (0, 1, 2, 3, 4, 5, 6)"},
       {"index-vectors-exist", "the frame on one side is one box", text_case("degree 3 3 3\ngrading 2\ndomain 4 4 4\n"),
        "index_set: it is (0, 1, 2, 3, 4)"},
       {"uniform-unperturbed", "forgotten hypothesis: one element is of level 1", middle, "the mesh is not uniform"},
       {"perturbed-cover-hanging", "forgotten direction: Rx", middle, "is in R_x"},
       {"perturbed-cover-hanging-repaired", "forgotten direction: Rx", middle, "is in R_x"},
       {"planar-equals-classical", lower, bad, "a horizontal and a vertical T-junction extension meet"},
       {"planar-equals-classical-repaired", lower, bad, "a horizontal and a vertical T-junction extension meet"},
       {"figure-slices", "the first line ends one cell earlier", middle, "the definitions give what is drawn for"},
       {"figure-proof-levels-repaired", "the patch is one element smaller",
        case_of_figure(correct_proof_figure(), {3, 3, 3}), "patch: nothing is violated"}});
}

/// Of both figures after Definition 5.2, each part at all half units: as drawn.
TEST(SkeletonWitnesses, OfTheSliceFiguresAreRejected) {
  const Case any = finding_case("new-node-split");
  for (const char* figure : {"the first figure after Definition 5.2", "the second figure after Definition 5.2"}) {
    for (const char* part : {"Nx(q)", "NA without Nx(q)", "the union of supports of Nx(q)",
                             "the union of the other supports", "Rx(q)", "the classical extension"}) {
      for (const char* y : {"0", "1", "3/2", "7/4", "5/2", "3", "4", "9/2"}) {
        const nlohmann::json witness{
            {"kind", "drawn-otherwise"},
            {"says", "the point belongs to the part as it is drawn or as the definitions have it, but not to both"},
            {"values", {{"figure", figure}, {"part", part}, {"point", {"3/2", y}}, {"drawn", "yes"}}}};
        const reference::Validation result = validated(any, "figure-slices", witness);
        EXPECT_NE(result.report.find("nothing is violated"), std::string::npos) << result.report << witness;
      }
    }
    for (const char* caption : {"analysis-suitable", "not analysis-suitable"}) {
      const nlohmann::json witness{{"kind", "caption-disagrees"},
                                   {"says", "the mesh is not what the caption calls it"},
                                   {"values", {{"figure", figure}, {"caption", caption}}}};
      EXPECT_FALSE(validated(any, "figure-slices", witness).valid) << witness;
    }
  }
}

}  // namespace
}  // namespace asts
