#include <map>

#include "lib/gen/random_case.hpp"
#include "tests/properties/claim_witnesses.hpp"

namespace asts {
namespace {

TEST(SuitabilityWitnesses, OfTheFindingsAreValid) {
  expect_valid("as-implies-dc", finding_case("as-implies-dc"),
               {"The mesh is analysis-suitable", "(2, 2, 2)", "(2, 2, 3)", "no overlap, by (6.1)"});
  expect_valid("dc-implies-as", finding_case("dc-implies-as"),
               {"The mesh is dual-compatible", "(5/2, 5/2, 4)", "(2, 2, 6)", "have the common point"});
  expect_valid("as-implies-dual-basis", finding_case("as-implies-dual-basis"),
               {"The mesh is analysis-suitable", "the Kronecker delta is 0"});
  expect_valid("case-table", finding_case("case-table"),
               {"Case 1 applies", "(2, 2, 2)", "(2, 2, 6)", "share no volume"});
}

constexpr const char* kNodeNoCorner = R"({"node":["9/4","2","2"],"index_vectors":{"x":["1","2","9/4","3","4"],
  "y":["0","1","2","3","4"],"z":["0","1","2","3","4"]},"support":{"lower":["1","0","0"],"upper":["4","4","4"]}})";

TEST(SuitabilityWitnesses, CorruptedImplications) {
  const Case dc = finding_case("as-implies-dc");
  expect_rejected("as-implies-dc", dc, witness_of("as-implies-dc", dc),
                  {{"/kind", "\"lambda-not-delta\"", "no such kind"},
                   {"/kind", "", "not an object with a text \"kind\""},
                   {"/says", "\"something\"", "a key that is none of its kind"},
                   {"/v/node/0", "\"3\"", "is not in the active region"},
                   {"/v/index_vectors/x/1", "\"5/4\"", "its index vector along x is (1, 3/2, 2, 3, 4)"},
                   {"/w/support/lower/2", "\"0\"", "its support is [0, 4] x [0, 4] x [1, 5]"},
                   {"/axes/0/coordinate", "\"2\"", "is in the other vector"},
                   {"/axes/0/in", "\"w\"", "is not in the vector"},
                   {"/axes/0/axis", "\"z\"", "is not in the vector"},
                   {"/axes/1", "{\"axis\":\"x\",\"coordinate\":\"3/2\",\"in\":\"v\"}", "listed twice"},
                   {"/w", "", "lacks the key \"w\""}});
  const Case suitable = finding_case("dc-implies-as");
  expect_rejected("dc-implies-as", suitable, witness_of("dc-implies-as", suitable),
                  {{"/point/2", "\"5\"", "not in the support"},
                   {"/point/0", "\"9\"", "not in the active region"},
                   {"/first/slice", "\"2\"", "not in the slice"},
                   {"/second/axis", "\"x\"", "second: (2, 2, 3) is in N_x(5/2)"},
                   {"/first/in", kNodeNoCorner, "is no node of the mesh"}});
  const Case dual = finding_case("as-implies-dual-basis");
  expect_rejected("as-implies-dual-basis", dual, witness_of("as-implies-dual-basis", dual),
                  {{"/value", "\"1/13\"", "the product of the factors is 1/36"},
                   {"/factors/1", "\"1/7\"", "factor along y"},
                   {"/failures", "4", "recounted: 2"},
                   {"/expected", "\"1\"", "expected: it is 0"}});
}

TEST(SuitabilityWitnesses, CorruptedCases) {
  const Case content = finding_case("case-table");
  const nlohmann::json witness = witness_of("case-table", content);
  expect_rejected("case-table", content, witness,
                  {{"/says", "\"the nodes are as a case of the proof has them, but they partially overlap\"",
                    "something that its kind does not say"},
                   {"/says", "", "not an object with a text \"says\""},
                   {"/values/first_axis", "\"z\"", "v1 is not in N_z(5/2)"},
                   {"/values/second_axis", "\"x\"", "same axis"},
                   {"/values/first_slice", "\"2\"", "v2 is in N_x(2)"},
                   {"/values/second_slice", "\"9/4\"", "v3 is not in N_y(9/4)"},
                   {"/values/v2/index_vectors/z/0", "\"3\"", "its index vector along z is (4, 5, 6, 7, 8)"},
                   {"/values/v3", "", "lacks the key \"v3\""},
                   {"/values/v5", "\"1\"", "a key that is none of its kind"},
                   {"/values", "[]", "is not an object"}});
  nlohmann::json swapped = witness;
  std::swap(swapped["values"]["v1"], swapped["values"]["v2"]);
  EXPECT_EQ(validated(content, "case-table", swapped).report, "v1 is not in N_x(5/2)");
  EXPECT_EQ(validated(content, "case-table-repaired", witness).report,
            "the witness says something that its kind does not say");
  EXPECT_EQ(validated(content, "dc-implies-as", witness).report, "there is no such kind of witness for this claim");
}

// Witnesses of other meshes: the hypothesis fails, or the conclusion does not.
TEST(SuitabilityWitnesses, OfAnotherMesh) {
  const auto other = [](const char* claim, const char* mesh) {
    return validated(finding_case(mesh), claim, witness_of(claim, finding_case(claim))).report;
  };
  EXPECT_EQ(other("as-implies-dc", "case-table"), "the mesh is not analysis-suitable: the claim says nothing about it");
  EXPECT_EQ(other("dc-implies-as", "as-implies-dc"),
            "the mesh is not dual-compatible: the claim says nothing about it");
  EXPECT_EQ(other("dc-implies-as", "frame-in-index-sets"),
            "the mesh has no active node: the claim says nothing about it");
  EXPECT_EQ(other("as-implies-dual-basis", "as-implies-dc"),
            "w: (3, 3, 2) is not in the active region [2, 2] x [2, 2] x [2, 3]");
  EXPECT_EQ(other("case-table", "new-node-split"), "v1: its index vector along x is (0, 1, 2, 3, 4)");
}

Verdict alone(const char* claim) { return try_alone(*find_claim(claim), Extent::short_run).verdict; }

TEST(SuitabilityWitnesses, OfTheTable) {
  const Case any = finding_case("new-node-split");
  const nlohmann::json witness = json_of(alone("case-table"));
  const reference::Validation result = validated(any, "case-table", witness);
  EXPECT_TRUE(result.valid) << result.report;
  EXPECT_NE(result.report.find("lists 2; the cases that apply are 4"), std::string::npos) << result.report;
  EXPECT_NE(result.report.find("10 of the 16 situations are wrong"), std::string::npos) << result.report;
  expect_rejected("case-table", any, witness,
                  {{"/values/situation", "\"v1\"", "none of the 16"},
                   {"/values/listed", "\"3\"", "the table's row has 2"},
                   {"/values/applying", "\"2\"", "those that apply are 4"},
                   {"/values/situations", "15", "there are 16"},
                   {"/values/wrong", "9", "there are 10"}});
}

// The faults of tests/properties/suitability_controls_test.cpp.
TEST(SuitabilityWitnesses, OfPlantedFaultsAreRejected) {
  const Case crossing = parse_case(
      "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 6 6 4\nsubdivide 5/2 5/2 3/2\nsubdivide 9/4 5/2 3/2\n", "c");
  const Case cubes = parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 5\n", "c");
  const char* const axes_mixed = "N_y(q) in place of N_x(q)";
  const char* const equal_vectors = "index vectors along x taken to be equal";
  expect_planted_rejected(
      suitability_controls(),
      {{"perturbed-means-no-overlap", axes_mixed, crossing, "v2 is in N_x(5/2)"},
       {"as-implies-dc", "R_y forgotten", crossing, "the mesh is not analysis-suitable"},
       {"as-implies-dc-repaired", "slices of the active region only", finding_case("as-implies-dc"),
        "with slices of the closed domain the mesh is not analysis-suitable"},
       {"dc-implies-as", equal_vectors, crossing, "the mesh is not dual-compatible"},
       {"dc-implies-as-repaired", "supports that share volume in place of supports that meet",
        finding_case("dc-implies-as"), "whose closed supports meet do not partially overlap"},
       {"case-table", axes_mixed, crossing, "v"},
       {"case-table-repaired", axes_mixed, crossing, "v"},
       {"case-table-repaired", "a row that lists another case", crossing, "listed: the table's row has 4"},
       {"dc-implies-dual-basis", equal_vectors, crossing, "the mesh is not dual-compatible"},
       {"as-implies-dual-basis", "R_y forgotten", crossing, "the mesh is not analysis-suitable"},
       {"as-implies-dual-basis-repaired", "slices of the active region only", finding_case("as-implies-dual-basis"),
        "with slices of the closed domain the mesh is not analysis-suitable"},
       {"dc-within-weak-dc", "a direction forgotten in the general definition", cubes,
        "v and w have different, overlapping vectors along some axis"}});
}

struct Tally {
  int meshes = 0;
  std::map<std::string, int> violated;
};

void look_at(const RandomCase& random, Tally& tally) {
  ++tally.meshes;
  for (const char* id : {"as-implies-dc", "dc-implies-as", "as-implies-dual-basis", "case-table"}) {
    const nlohmann::json witness = witness_of(id, random.content);
    if (witness.is_null()) continue;
    ++tally.violated[id];
    const reference::Validation result = validated(random.content, id, witness);
    ASSERT_TRUE(result.valid) << id << ": " << result.report << "\n" << write_case(random.content) << witness.dump(1);
  }
}

TEST(SuitabilityWitnesses, OfRandomMeshesAreValid) {
  CaseLimits limits;
  limits.max_cubes = 110;
  limits.max_elements = 130;
  Tally tally;
  Draw draw(7);
  while (tally.violated["as-implies-dc"] + tally.violated["as-implies-dual-basis"] < 200 && !HasFailure()) {
    look_at(draw.one_in(2) ? random_bare_case(draw, limits) : random_trouble_case(draw, limits), tally);
  }
  EXPECT_GE(tally.violated["as-implies-dual-basis"], 40);
}

TEST(SuitabilityWitnesses, OfRandomMeshesWhoseSupportsTouchAreValid) {
  CaseLimits limits;
  limits.max_cubes = 250;
  limits.max_elements = 260;
  Tally tally;
  Draw draw(11);
  while (tally.violated["dc-implies-as"] + tally.violated["case-table"] < 10 && tally.meshes < 3000 && !HasFailure()) {
    const Setting setting = setting_for(draw, limits, Bias::bare_interface);
    look_at(random_case_in(draw, setting, limits, Bias::bare_interface), tally);
  }
  EXPECT_GE(tally.violated["case-table"], 10);
}

}  // namespace
}  // namespace asts
