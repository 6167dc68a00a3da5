#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/reference/complexity_checks.hpp"
#include "tests/reference/refine.hpp"
#include "tests/reference/refinement_claims.hpp"
#include "tests/reference/root_text.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {
namespace {

using nlohmann::json;

std::vector<ClaimKind> own_kinds() {
  std::vector<ClaimKind> all;
  for (const auto family : {refinement_kinds, equation_kinds, complexity_kinds, functional_kinds}) {
    const std::span<const ClaimKind> kinds = family();
    all.insert(all.end(), kinds.begin(), kinds.end());
  }
  return all;
}

/// The rows of the tables of reports/WITNESS.md.
std::vector<std::string> written_rows() {
  std::ifstream file(std::string(ASTS_CASES) + "/../../reports/WITNESS.md");
  std::vector<std::string> rows;
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("| `")) rows.push_back(line);
  return rows;
}

TEST(ClaimWitnessForms, AreWrittenDown) {
  const std::vector<std::string> rows = written_rows();
  for (const ClaimKind& kind : own_kinds()) {
    const std::string start = std::string("| `") + kind.claim + "` | `" + kind.kind + "` |";
    const std::string says = kind.says == nullptr ? "" : "\"" + std::string(kind.says) + "\"";
    const bool written = std::any_of(rows.begin(), rows.end(), [&](const std::string& row) {
      return row.starts_with(start) && row.find(says) != std::string::npos;
    });
    EXPECT_TRUE(written) << kind.claim << ", " << kind.kind << ": " << says;
  }
}

// m = 5: t = 1.7099..., t^2 = 2.9240...: 5/2 - t/3 + 2 t^2 = 7.7780...
TEST(RootText, IsReadAndWritten) {
  const RootSum number{5, Rational(5) / 2, Rational(-1) / 3, 2};
  const std::string written = "5/2 - 1/3 5^(1/3) + 2 5^(2/3), between 7.778 and 7.7781";
  EXPECT_EQ(sign(read_root_sum(written, 5, "it") - number), 0);
  EXPECT_EQ(text(number), "5/2 - 1/3 5^(1/3) + 2 5^(2/3), between 7.778043494200 and 7.778043494201");
  EXPECT_EQ(sign(read_root_sum(text(number), 5, "it") - number), 0);
  EXPECT_EQ(text(RootSum{5, 0, -1}), "-5^(1/3), between -1.709975946677 and -1.709975946676");
  EXPECT_EQ(text(RootSum{8, 1, 1, 1}), "7") << "1 + 2 + 4";
  EXPECT_EQ(sign(read_root_sum("-7/4", 5, "it") - RootSum{5, Rational(-7) / 4}), 0);
}

TEST(RootText, IsRejected) {
  for (const char* wrong :
       {"", "-", "1 +", "2/4", "5^(1/3)", "5^(1/3), between 1.70 and 1.709", "5^(1/3), between 1.8 and 1.7",
        "5^(1/3), between 1.7", "1 5^(1/3), between 1.7 and 1.8", "5^(4/3), between 8 and 9",
        "55^(1/3), between 3 and 4", "5^(2/3) + 5^(1/3), between 4 and 5", "7, between 6 and 8", "0.5",
        "5^(1/3), between 1.7 and 1.8 or so", "0 + 5^(1/3), between 1.7 and 1.8", "4^(1/3), between 1.5 and 1.6"}) {
    EXPECT_THROW(read_root_sum(wrong, 5, "it"), Rejected) << wrong;
  }
  EXPECT_THROW(read_root_sum(json(7), 5, "it"), Rejected);
}

/// A witness as it is read: its counts are unsigned.
json read_back(const json& witness) { return json::parse(witness.dump()); }

/// A sequence with two marks in a step, and levels above 6, on the grid and on boxes.
TEST(SubdividedSet, FollowsAlgorithm29) {
  const Setting setting{{3, 3, 3}, 2, {3, 1, 2}};
  std::vector<LiteralStep> steps{{true, {{0, 0, 0}, {Rational(5) / 2, 1, 2}}}};
  for (int n = 0; n < 8; ++n) steps.push_back({true, {{0, 0, 0}, {0, Rational(1) / 100, 0}}});
  ClaimSubject subject(setting, steps);
  const LiteralSequence sequence = follow_literally(subject, steps.size());
  Mesh fresh;
  for (const Box& box : subject.mesh())
    if (level(setting, box) > 0) fresh.push_back(box);
  Mesh found;
  for (const GridBox& element : sequence.mesh.new_elements()) found.push_back(sequence.mesh.box(element));
  std::sort(fresh.begin(), fresh.end());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, fresh);
  EXPECT_EQ(sequence.fresh.back(), fresh.size());
  EXPECT_EQ(sequence.marked[0], 2U);
  EXPECT_EQ(sequence.marks.size(), 2U + 8U) << "the second point is in the same element";
  EXPECT_TRUE(sequence.mesh.admissible());
  const auto deepest = std::max_element(sequence.marks.begin(), sequence.marks.end(),
                                        [](const GridBox& a, const GridBox& b) { return a.level < b.level; });
  EXPECT_EQ(deepest->level, 8);
  EXPECT_THROW(follow_literally(subject, steps.size() + 1), Rejected);
  EXPECT_THROW(SubdividedSet(setting, 200), std::overflow_error);
}

// Both sums of one small sequence, by the boxes' own definition and on the grid.
TEST(SubdividedSet, AddsUpLambda) {
  const Setting setting{{3, 3, 3}, 3, {4, 1, 1}};
  const std::vector<LiteralStep> steps{{true, {{0, 0, 0}}}, {true, {{0, 0, 0}}}, {true, {{4, 1, 1}}}};
  const LiteralSequence sequence = follow_literally(ClaimSubject(setting, steps), 3);
  for (const GridBox& k : sequence.mesh.new_elements())
    EXPECT_GE(sign(sequence.mesh.lambda_sum(k, sequence.marks, distance_constant).sum - RootSum{3, 1}), 0);
  const LambdaSum over_new = sequence.mesh.lambda_sum_over_new(sequence.marks[0], distance_constant);
  const std::vector<GridBox> fresh = sequence.mesh.new_elements();
  const auto near = std::count_if(fresh.begin(), fresh.end(), [](const GridBox& k) { return k.level <= 1; });
  EXPECT_EQ(over_new.within, static_cast<std::size_t>(near)) << "K of level 2 is too fine for a mark of level 0";
  EXPECT_LT(over_new.within, fresh.size());
}

/// The first cube of a row of 6, cut twice: the quarter [0, 1/2] x [0, 1/2] needs three coarser elements.
class Corner : public testing::Test {
 protected:
  const Setting setting{{3, 3, 3}, 2, {6, 1, 1}};
  const std::vector<LiteralStep> steps{{false, {{0, 0, 0}}}, {false, {{0, 0, 0}}}};
  ClaimSubject subject{setting, steps};
  const json quarter{{"lower", {"0", "0", "0"}}, {"upper", {"1/2", "1/2", "1"}}, {"level", 2}};
  const json half{{"lower", {"1/2", "0", "0"}}, {"upper", {"1", "1", "1"}}, {"level", 1}};
  const json far{{"lower", {"5", "0", "0"}}, {"upper", {"6", "1", "1"}}, {"level", 0}};

  /// The reason for which the witness is rejected.
  std::string reason(const char* claim, const char* kind, const char* says, const json& values) {
    const Validation result =
        validate_claim_witness(subject, claim, read_back({{"kind", kind}, {"says", says}, {"values", values}}));
    EXPECT_FALSE(result.valid) << says;
    return result.report;
  }
};

TEST_F(Corner, InEveryClosedSuperset) {
  const Patches all = patches(setting, subject.mesh());
  const auto at = [&](const json& value) { return position_in_mesh(setting, subject.mesh(), value, "it"); };
  EXPECT_TRUE(in_every_closed_superset(all, {at(quarter)}, at(quarter)));
  EXPECT_TRUE(in_every_closed_superset(all, {at(quarter)}, at(half)));
  EXPECT_FALSE(in_every_closed_superset(all, {at(quarter)}, at(far)));
  EXPECT_FALSE(in_every_closed_superset(all, {at(half)}, at(quarter)));
}

// Every law of the closure: an element that is in both sets, one that is in neither.
TEST_F(Corner, ClosureWitnessesAreRejected) {
  for (const ClaimKind& form : refinement_kinds()) {
    if (std::string(form.kind) != "wrong-closure") continue;
    json values{{"mark 1", quarter}, {"element missing", half}};
    const bool mirrors = std::string(form.says).starts_with("the mirrored");
    if (mirrors) {
      values["mirrored along"] = "y, z";
      values["mark 1"] = {{"lower", {"0", "1/2", "0"}}, {"upper", {"1/2", "1", "1"}}, {"level", 2}};
    }
    const bool half_of_marks = std::string(form.says).starts_with("the first half");
    const char* expected = half_of_marks ? "is in the closure of the marks alone" : "is in both";
    EXPECT_NE(reason(form.claim, form.kind, form.says, values).find(expected), std::string::npos) << form.says;
    values["element missing"] = far;
    EXPECT_NE(reason(form.claim, form.kind, form.says, values).find("is in neither"), std::string::npos) << form.says;
    values["element too many"] = far;
    EXPECT_EQ(reason(form.claim, form.kind, form.says, values), "values has a key that is none of its kind");
  }
  const char* const mirrored = "the mirrored marks have another closure than the mirrored one";
  const json values{{"mark 1", quarter}, {"element missing", half}, {"mirrored along", "x"}};
  EXPECT_NE(reason("closure-least", "wrong-closure", mirrored, values).find("mark: "), std::string::npos)
      << "the quarter is no element of the mirrored mesh";
}

TEST_F(Corner, OrdersMakeTheSameMesh) {
  const char* const says = "two orders of these subdivisions make different meshes";
  json values{{"element 1", quarter}, {"element 2", half}, {"other order", {"2", "1"}}};
  EXPECT_EQ(reason("subdivision-commutes", "order-matters", says, values),
            "both orders of the 2 subdivisions make the same mesh of 10 elements");
  values["other order"] = {"2", "2"};
  EXPECT_EQ(reason("subdivision-commutes", "order-matters", says, values), "other order: not the numbers from 1 to 2");
  values["element 2"] = quarter;
  EXPECT_EQ(reason("subdivision-commutes", "order-matters", says, values), "an element is there twice");
}

TEST_F(Corner, EnvironmentsAndRadiiAreWhatTheyAre) {
  json values{{"K", quarter}, {"axis", "x"}, {"value", "0"}, {"compared with", "0"}};
  EXPECT_EQ(reason("patch-shrinks-with-grading", "environment", "U(K) begins elsewhere", values), "both sides are 0");
  values = {{"K", quarter}, {"axis", "x"}, {"value", "5/2"}, {"compared with", "9/4"}};
  EXPECT_EQ(reason("patch-shrinks-with-grading", "environment", "U(K) ends elsewhere", values),
            "the midpoint with D(l(K)), cut off at the domain's end, is 5/2, not 9/4");
  values = {{"axis", "z"},    {"degree along the axis", 3}, {"level", 2}, {"grading", 2},
            {"value", "9/2"}, {"compared with", "9/2"}};
  EXPECT_EQ(reason("patch-shrinks-with-grading", "patch-radius", "D(k) is not size * (p + 3/2)", values),
            "D(k) is the size times p + 3/2: both are 9/2");
  values["level"] = 3;
  EXPECT_EQ(reason("patch-shrinks-with-grading", "patch-radius", "D(k) is not size * (p + 3/2)", values),
            "D(k) along the axis is 9/4, not 9/2");
}

// One cube, cut: the subdivision of the half's closure is admissible.
TEST(ClaimWitnessForms, SubdivisionOfAClosureIsAdmissible) {
  ClaimSubject subject({{3, 3, 3}, 2, {6, 1, 1}}, {{true, {{0, 0, 0}}}});
  const json half{{"lower", {"0", "0", "0"}}, {"upper", {"1/2", "1", "1"}}, {"level", 1}};
  const Validation result =
      validate_claim_witness(subject, "refine-admissible",
                             {{"kind", "subdivision-not-admissible"},
                              {"says", "no order makes each subdivision of the closure admissible"},
                              {"values", {{"mark 1", half}}}});
  EXPECT_FALSE(result.valid);
  EXPECT_EQ(result.report, "there is an order: each of the 3 subdivisions of the closure is admissible");
}

/// The reason for which a witness without a mesh is rejected.
std::string reason_alone(const char* claim, const char* kind, const char* says, const json& values) {
  ClaimSubject none = ClaimSubject::none();
  const Validation result =
      validate_claim_witness(none, claim, read_back({{"kind", kind}, {"says", says}, {"values", values}}));
  EXPECT_FALSE(result.valid) << says;
  return result.report;
}

TEST(ClaimWitnessForms, BoundsOfLevelsHold) {
  const char* const says = "a coordinate exceeds its bound";
  json values{{"m", 8},
              {"degrees", {"3", "5", "3"}},
              {"k", 1},
              {"axis", "y"},
              {"value", {"9/16", "13/2", "9/2"}},
              {"bound along the axis", "13/2"}};  // 8^(-1/3) 8^(1/3) (5 + 3/2)
  EXPECT_EQ(reason_alone("radius-bounds", "radius-unbounded", says, values), "the bound holds: 13/2 <= 13/2");
  values["degrees"][1] = "4";
  EXPECT_EQ(reason_alone("radius-bounds", "radius-unbounded", says, values), "degrees: not odd, or not from 3 to 1001");
  values["degrees"][1] = "5";
  values["value"] = {"1/8", "1", "1"};
  values["bound along the axis"] = "1";
  EXPECT_EQ(reason_alone("radius-bounds", "size-unbounded", says, values), "the bound holds: 1 <= 1");
  values = {{"m", 8}, {"k", 1}, {"size(k)", {"1/8", "1", "1"}}, {"size(k - 1)", {"1", "1", "1"}}};
  EXPECT_EQ(reason_alone("radius-bounds", "size-grows", "size(k) exceeds size(k - 1)", values),
            "size(k) = (1/8, 1, 1) is at most size(k - 1) = (1, 1, 1) along each axis");
}

TEST(ClaimWitnessForms, TheLimitsAreTheStatedOnes) {
  const std::string bound = text(complexity_constant({{3, 3, 3}, 5, {5, 5, 5}}) * (Rational(1) / 2849));
  json values{{"m", 5}, {"limit stated", 924}, {"late steps", {"924", "924", "924"}}, {"C/2849", bound}};
  const char* const says = "what late steps add is not the limit stated, or not below C/2849";
  EXPECT_TRUE(reason_alone("experiment-constant-repaired", "other-limit", says, values)
                  .starts_with("late steps add 924, below C/2849"));
  values["late steps"][1] = "925";
  EXPECT_EQ(reason_alone("experiment-constant-repaired", "other-limit", says, values),
            "what late steps add is (924, 924, 924), not (924, 925, 924)");
}

TEST(ClaimWitnessForms, TheSecondSumIsAtMostC) {
  ClaimSubject subject({{3, 3, 3}, 8, {2, 1, 1}}, {{true, {{0, 0, 0}}}});
  // the eight children have lambda = 8^(1/3); C is that of ComplexityConstants.ByHand
  json witness{{"kind", "sum-above-C"},
               {"says", "the sum of lambda(K,K~) over all new K exceeds C"},
               {"values",
                {{"K~", {{"lower", {"0", "0", "0"}}, {"upper", {"1", "1", "1"}}, {"level", 0}}},
                 {"sum", "16"},
                 {"C", "47045881/16"}}}};
  EXPECT_EQ(validate_claim_witness(subject, "lambda-sums", witness).report, "the sum is at most C: 16 <= 47045881/16");
  EXPECT_EQ(validate_claim_witness(subject, "lambda-sums-repaired", witness).report,
            "the sum is at most C: 16 <= 47045881/16")
      << "the printed constants do for m = 8 too";
  witness["values"]["sum"] = "15";
  EXPECT_EQ(validate_claim_witness(subject, "lambda-sums", witness).report, "the sum is 16, not 15");
}

TEST(ClaimWitnessForms, OverlappingVectorsAreDual) {
  const json values{
      {"x", {"0", "1", "2", "3", "4"}}, {"x_tilde", {"1", "2", "3", "4", "5"}}, {"value", "0"}, {"expected", 0}};
  const char* const says = "the vectors overlap, and lambda_X(N_X~) is not delta";
  EXPECT_EQ(reason_alone("overlap-duality", "not-delta", says, values), "lambda_X(N_X~) is delta: 0");
  json apart = values;
  apart["x_tilde"] = {"0", "1", "2", "5/2", "3"};
  EXPECT_EQ(reason_alone("overlap-duality", "not-delta", says, apart), "the vectors do not overlap");
}

}  // namespace
}  // namespace asts::reference
