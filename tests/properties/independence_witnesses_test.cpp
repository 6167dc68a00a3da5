#include "tests/properties/claim_witnesses.hpp"

namespace asts {
namespace {

const char* const kClaim = "dc-implies-independent";

Case cubes() { return parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 6 5 4\n", "cubes"); }

/// (2,2,2) and (3,2,2) with coefficients of a dependence that does not exist.
nlohmann::json invented() {
  return nlohmann::json::parse(
      R"({"kind":"dependent","says":"the sum of coefficient times B_node is 0 on every element",
    "values":{"coefficient_1":"1","node_1":{"node":["2","2","2"],"index_vectors":{"x":["0","1","2","3","4"],
    "y":["0","1","2","3","4"],"z":["0","1","2","3","4"]},"support":{"lower":["0","0","0"],"upper":["4","4","4"]}},
    "coefficient_2":"-1","node_2":{"node":["3","2","2"],"index_vectors":{"x":["1","2","3","4","5"],
    "y":["0","1","2","3","4"],"z":["0","1","2","3","4"]},"support":{"lower":["1","0","0"],"upper":["5","4","4"]}}}})");
}

// The integrals of the cubic B-spline's square and of its product with the next one are 151/315 and 397/1680: the
// square of the difference has the integral 2 (151/315)^2 (151/315 - 397/1680).
TEST(IndependenceWitnesses, SayTheIntegralThatIsNotZero) {
  const reference::Validation result = validated(cubes(), kClaim, invented());
  EXPECT_FALSE(result.valid);
  const Rational side(151, 315);
  const Rational square = 2 * side * side * (side - Rational(397, 1680));
  EXPECT_EQ(result.report,
            "nothing is violated: the integral of the square of the sum is " + to_string(square) + ", not 0");
}

TEST(IndependenceWitnesses, OfThePlantedFaultAreRejected) {
  expect_planted_rejected(independence_controls(),
                          {{kClaim, "an index vector shifted by one entry", cubes(), "its index vector along x is"}});
}

TEST(IndependenceWitnesses, Corrupted) {
  expect_rejected(kClaim, cubes(), invented(),
                  {{"/values/coefficient_1", "\"0\"", "coefficient_1 is 0"},
                   {"/values/coefficient_2", "-1", "not a number"},
                   {"/values/coefficient_2", "", "not coefficients and nodes"},
                   {"/values/node_2/node/0", "\"2\"", "its index vector along x is (0, 1, 2, 3, 4)"},
                   {"/values/node_2/support/upper/0", "\"4\"", "its support is"},
                   {"/values", "{}", "not coefficients and nodes"},
                   {"/values", "{\"coefficient_1\":\"1\",\"node_2\":\"1\"}", "lacks the key"}});
  nlohmann::json twice = invented();
  twice["values"]["node_2"] = twice["values"]["node_1"];
  EXPECT_EQ(validated(cubes(), kClaim, twice).report, "node_2: the node is named twice");
  const Case bad = read_case_file(std::string(ASTS_CASES) + "/planar/published-bad-tmesh.case");
  EXPECT_EQ(validated(bad, kClaim, invented()).report,
            "the mesh is not dual-compatible: the claim says nothing about it");
}

}  // namespace
}  // namespace asts
