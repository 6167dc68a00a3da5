#include "tests/reference/validate.hpp"

#include <gtest/gtest.h>

#include "tests/reference/decide.hpp"
#include "tests/reference/example_meshes.hpp"

namespace asts::reference {
namespace {

using nlohmann::json;

// v = (7/2, 4, 2) and w = (4, 9/2, 2) of the crossing example, written by hand (see example_meshes.hpp).
const json node_v = json::parse(R"({"node":["7/2","4","2"],"index_vectors":{"x":["2","3","7/2","4","5"],
  "y":["2","3","4","5","6"],"z":["0","1","2","3","4"]},"support":{"lower":["2","2","0"],"upper":["5","6","4"]}})");
const json node_w = json::parse(R"({"node":["4","9/2","2"],"index_vectors":{"x":["2","3","4","5","6"],
  "y":["3","4","9/2","5","6"],"z":["0","1","2","3","4"]},"support":{"lower":["2","3","0"],"upper":["6","6","4"]}})");

json regions_witness() {
  return {{"kind", "perturbed-regions-meet"},
          {"point", {"7/2", "9/2", "2"}},
          {"first", {{"axis", "x"}, {"slice", "7/2"}, {"in", node_v}, {"out", node_w}}},
          {"second", {{"axis", "y"}, {"slice", "9/2"}, {"in", node_w}, {"out", node_v}}}};
}

json overlap_witness() {
  return {{"kind", "no-partial-overlap"},
          {"v", node_v},
          {"w", node_w},
          {"axes",
           {{{"axis", "x"}, {"coordinate", "7/2"}, {"in", "v"}}, {{"axis", "y"}, {"coordinate", "9/2"}, {"in", "w"}}}}};
}

std::string written(const Rational& value) {
  return value.str();
}

json written(const CosineField& field, const Number& value) {
  if (is_rational(value)) return written(value[0]);
  json coefficients = json::array(), minimal = json::array();
  for (const Rational& c : value) coefficients.push_back(written(c));
  for (const Rational& c : field.minimal()) minimal.push_back(written(c));
  const bool positive = field.sign(value) > 0;
  return {{"coefficients", coefficients},
          {"generator", "2*cos(pi/" + std::to_string(field.n()) + ")"},
          {"minimal_polynomial", minimal},
          {"enclosure", {positive ? "0.00" : "-100.5", positive ? "100.5" : "0.00"}}};
}

json dual_witness(const CrossingExtensions& example) {
  const Space<Rational> space = make_space<Rational>(example.setting, example.mesh, 1);
  const auto splines = *active_splines(space);
  const DualCount count = count_dual_failures(example.setting.degree, splines, false);
  const auto v = *active_node(space, {over(7, 2), 4, 2}), w = *active_node(space, {4, over(9, 2), 2});
  std::array<Number, dimension> factors;
  json printed = json::array();
  for (std::size_t a = 0; a < dimension; ++a) {
    factors[a] = lambda(v.vectors[a], w.vectors[a]);
    printed.push_back(written(CosineField::get(4), factors[a]));
  }
  return {{"kind", "lambda-not-delta"}, {"v", node_v}, {"w", node_w}, {"factors", printed},
          {"value", written(CosineField::get(4), product_of_factors(example.setting.degree, factors))},
          {"expected", "0"}, {"failures", count.failures}, {"pairs", count.pairs}};
}

/// Every single leaf replaced by other things, every key removed or added: all must be rejected, none may throw.
void expect_all_corruptions_rejected(const Setting& setting, const Mesh& mesh, const std::string& property,
                                     const json& witness) {
  const Validation good = validate_witness(setting, mesh, property, witness);
  EXPECT_TRUE(good.valid) << good.report;
  const json replacements = {nullptr, 17, -3, 0.5, true, "", "77/3", "7/2 ", "4/2", "1/0", "-0", "x y", json::array(),
                             json::object(), 18446744073709551615U};
  const json flat = witness.flatten();
  for (const auto& leaf : flat.items())
    for (const json& replacement : replacements) {
      json bad = witness;
      bad[json::json_pointer(leaf.key())] = replacement;
      EXPECT_FALSE(validate_witness(setting, mesh, property, bad).valid) << leaf.key() << " = " << replacement;
    }
  for (const auto& entry : witness.items()) {
    json bad = witness;
    bad.erase(entry.key());
    EXPECT_FALSE(validate_witness(setting, mesh, property, bad).valid) << entry.key();
    if (!entry.value().is_object()) continue;
    bad = witness;
    bad[entry.key()]["extra"] = "1";
    EXPECT_FALSE(validate_witness(setting, mesh, property, bad).valid) << entry.key();
  }
}

TEST(ReferenceValidate, HandWrittenSplineWitnesses) {
  const CrossingExtensions example;
  expect_all_corruptions_rejected(example.setting, example.mesh, "analysis-suitable", regions_witness());
  expect_all_corruptions_rejected(example.setting, example.mesh, "dual-compatible", overlap_witness());
}

TEST(ReferenceValidate, DualWitness) {
  const CrossingExtensions example;
  expect_all_corruptions_rejected(example.setting, example.mesh, "dual-basis", dual_witness(example));
  json wrong = dual_witness(example);
  wrong["failures"] = wrong["failures"].get<int>() + 1;
  EXPECT_FALSE(validate_witness(example.setting, example.mesh, "dual-basis", wrong).valid);
}

TEST(ReferenceValidate, OutsideClassWitness) {
  const CrossingExtensions example;
  const json witness = {{"kind", "outside-class"},
                        {"element", {{"lower", {"4", "4", "0"}}, {"upper", {"5", "9/2", "1"}}, {"level", 1}}}};
  expect_all_corruptions_rejected(example.setting, example.mesh, "admissible", witness);
  EXPECT_FALSE(validate_witness(example.setting, example.mesh, "nested-patches", witness).valid);
}

// E = [0,1/2] x [0,1] x [0,1] of level 1 was subdivided, U(E) = (0, 5/2) x (0, 4) x (0, 5) in the domain 4 x 4 x 5, and
// the unit cube [2,3] x [3,4] x [4,5] meets it. The cube [3,4] x ... does not.
TEST(ReferenceValidate, CoarserInPatchWitness) {
  const BareSubdivisions example;
  json witness = {{"kind", "coarser-in-patch"},
                  {"element", {{"lower", {"0", "0", "0"}}, {"upper", {"1/2", "1", "1"}}, {"level", 1}}},
                  {"environment", {{"lower", {"0", "0", "0"}}, {"upper", {"5/2", "4", "5"}}}},
                  {"coarser", {{"lower", {"2", "3", "4"}}, {"upper", {"3", "4", "5"}}, {"level", 0}}}};
  expect_all_corruptions_rejected(example.setting, example.mesh, "admissible", witness);
  witness["coarser"] = {{"lower", {"3", "3", "4"}}, {"upper", {"4", "4", "5"}}, {"level", 0}};
  EXPECT_FALSE(validate_witness(example.setting, example.mesh, "admissible", witness).valid);
}

TEST(ReferenceValidate, NestedPatchesCannotBeRefutedHere) {
  const BareSubdivisions example;
  const json half = {{"lower", {"0", "0", "0"}}, {"upper", {"1/2", "1", "1"}}, {"level", 1}};
  const json cube = {{"lower", {"0", "0", "0"}}, {"upper", {"1", "1", "1"}}, {"level", 0}};
  const json other = {{"lower", {"2", "3", "4"}}, {"upper", {"3", "4", "5"}}, {"level", 0}};
  const json witness = {{"kind", "patch-not-nested"}, {"inner", half}, {"outer", cube}, {"element", other}};
  const Validation result = validate_witness(example.setting, example.mesh, "nested-patches", witness);
  EXPECT_FALSE(result.valid);
  EXPECT_EQ(result.report, "the element is in the patch of outer");
}

TEST(ReferenceValidate, NoWitnessIsAnException) {
  const CrossingExtensions example;
  for (const json& nonsense : {json(), json(3), json("kind"), json::array({1}), json{{"kind", 3}}, json{{"kind", "x"}}})
    EXPECT_FALSE(validate_witness(example.setting, example.mesh, "dual-basis", nonsense).valid);
  const Mesh gap(example.mesh.begin() + 1, example.mesh.end());
  EXPECT_FALSE(validate_witness(example.setting, gap, "dual-compatible", overlap_witness()).valid);
}

}  // namespace
}  // namespace asts::reference
