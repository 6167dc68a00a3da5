#include <gtest/gtest.h>

#include "tests/properties/claim_witness_checks.hpp"

// Valid witnesses of refuted claims with one thing changed: each is rejected, and for the right reason.
namespace asts::witness_checks {
namespace {

using nlohmann::json;

struct Corruption {
  const char* what;
  const char* patch;  ///< RFC 6902
  const char* reason;
};

void expect_corruptions_rejected(const char* claim, const std::vector<Corruption>& corruptions) {
  const Case content = finding(claim);
  const json good = witness_of(claim, content);
  reference::ClaimSubject subject = subject_of(content);
  EXPECT_TRUE(reference::validate_claim_witness(subject, claim, good).valid);
  for (const Corruption& corruption : corruptions) {
    const json bad = good.patch(json::parse(corruption.patch));
    EXPECT_NE(bad, good) << corruption.what;
    const reference::Validation result = reference::validate_claim_witness(subject, claim, bad);
    EXPECT_FALSE(result.valid) << corruption.what;
    EXPECT_NE(result.report.find(corruption.reason), std::string::npos)
        << claim << ": " << corruption.what << ": " << result.report << "\n"
        << bad.dump();
  }
}

TEST(CorruptedClaimWitness, OfTheChildsDistanceIsRejected) {
  expect_corruptions_rejected(
      "child-distance",
      {{"m changed", R"json([{"op":"replace","path":"/values/m","value":2}])json", "m is 3, not 2"},
       {"m negative", R"json([{"op":"replace","path":"/values/m","value":-3}])json", "m is not a count"},
       {"K^ enlarged", R"json([{"op":"replace","path":"/values/K^/upper/0","value":"2"}])json", "K^: [0, 2]"},
       {"K moved", R"json([{"op":"replace","path":"/values/K/lower/0","value":"1/3"},
                       {"op":"replace","path":"/values/K/upper/0","value":"2/3"}])json",
        "child number j of K^ is [0, 1/3]"},
       {"K's level off", R"json([{"op":"replace","path":"/values/K/level","value":2}])json", "K: its level is 1"},
       {"K^'s level forgotten", R"json([{"op":"replace","path":"/values/K^/level","value":null}])json",
        "K^: its level is 0"},
       {"j of another child", R"json([{"op":"replace","path":"/values/j","value":3}])json",
        "child number j of K^ is [2/3, 1]"},
       {"j counted from 0", R"json([{"op":"replace","path":"/values/j","value":0}])json", "j is not from 1 to m"},
       {"j a text", R"json([{"op":"replace","path":"/values/j","value":"1"}])json", "j is not a count"},
       {"another distance", R"json([{"op":"replace","path":"/values/Dist(K,K^)/0","value":"1/9"}])json",
        "Dist(K,K^) is (1/3, 0, 0), not (1/9, 0, 0)"},
       {"another printed distance", R"json([{"op":"replace","path":"/values/printed, by l(K^)/0","value":"1/27"}])json",
        "printed, by l(K^) is (1/9, 0, 0)"},
       {"the printed distance along another axis",
        R"json([{"op":"replace","path":"/values/printed, by l(K^)","value":["0","1/9","0"]}])json",
        "printed, by l(K^) is (1/9, 0, 0)"},
       {"a key missing", R"json([{"op":"remove","path":"/values/j"}])json", "values lacks the key \"j\""},
       {"a key added", R"json([{"op":"add","path":"/values/also","value":"1"}])json", "values has a key"},
       {"a key of the witness added", R"json([{"op":"add","path":"/mesh","value":"1"}])json", "the witness has a key"},
       {"no values", R"json([{"op":"replace","path":"/values","value":["1"]}])json", "values is not an object"},
       {"the other formula's words",
        R"json([{"op":"replace","path":"/says","value":"Dist(K,K^) is not what the formula by the child's level says"}])json",
        "lacks the key \"printed, by l(K)\""},
       {"other words", R"json([{"op":"replace","path":"/says","value":"Dist(K,K^) is wrong"}])json", "says something"},
       {"no words", R"json([{"op":"remove","path":"/says"}])json", "no"},
       {"another claim's kind", R"json([{"op":"replace","path":"/kind","value":"bound-exceeded"}])json",
        "no such kind"},
       {"no lowest terms", R"json([{"op":"replace","path":"/values/Dist(K,K^)/0","value":"2/6"}])json", "lowest terms"},
       {"a floating-point number", R"json([{"op":"replace","path":"/values/Dist(K,K^)/0","value":0.25}])json",
        "not a number"},
       {"a point in the plane", R"json([{"op":"remove","path":"/values/Dist(K,K^)/2"}])json", "not a point"}});
}

TEST(CorruptedClaimWitness, OfTheChildsBoundIsRejected) {
  expect_corruptions_rejected(
      "child-distance-bound",
      {{"another axis", R"json([{"op":"replace","path":"/values/axis","value":"y"}])json", "the bound is"},
       {"no axis", R"json([{"op":"replace","path":"/values/axis","value":"w"}])json", "not a axis"},
       {"another bound", R"json([{"op":"replace","path":"/values/bound along the axis","value":"1/3"}])json",
        "the bound is 1/9, not 1/3"},
       {"the middle child, which keeps the bound",
        R"json([{"op":"replace","path":"/values/K/lower/0","value":"1/3"},
            {"op":"replace","path":"/values/K/upper/0","value":"2/3"},
            {"op":"replace","path":"/values/j","value":2},
            {"op":"replace","path":"/values/Dist(K^,K)/0","value":"0"}])json",
        "the bound holds: 0 <= 1/9"},
       {"a rational number with decimals",
        R"json([{"op":"replace","path":"/values/bound along the axis","value":"1/9, between 0.1 and 0.2"}])json",
        "a rational one has none"}});
}

/// The bound, "EXACT, between LOWER and UPPER", with one part of it changed.
json with_bound(json witness, const std::string& from, const std::string& to) {
  std::string bound = witness["values"]["bound along the axis"];
  const std::size_t place = bound.find(from);
  if (place == std::string::npos) throw std::out_of_range(from + " is not in " + bound);
  witness["values"]["bound along the axis"] = bound.replace(place, from.size(), to);
  return witness;
}

/// The slab of these numbers among the 1315 of the first cube.
json slab(int number) {
  const auto side = [](int place) { return json(to_string(Rational(place) / 1315)); };
  return {{"lower", {side(number), "0", "0"}}, {"upper", {side(number + 1), "1", "1"}}, {"level", 1}};
}

json with_value(json witness, const char* name, const json& value) {
  witness["values"][name] = value;
  return witness;
}

TEST(CorruptedClaimWitness, OfTheDistanceBoundIsRejected) {
  const Case content = finding("distance-bound");
  const json good = witness_of("distance-bound", content);
  const std::string bound = good["values"]["bound along the axis"];
  const std::string exact = bound.substr(0, bound.find(','));
  const std::vector<std::pair<json, const char*>> corrupted{
      {with_bound(good, "between 1.00222", "between 1.00223"), "do not enclose"},
      {with_bound(good, bound.substr(exact.size()), ", between 1.1 and 1"), "do not enclose"},
      {with_bound(good, "between", "about"), "no enclosure"},
      {with_bound(good, bound.substr(exact.size()), ""), "two decimals around it"},
      {with_bound(good, "1315^(1/3)", "1314^(1/3)"), "not a"},
      {with_bound(good, " + ", " - "), "do not enclose"},
      {with_bound(good, exact, "0 + " + exact), "it is written"},
      {with_value(good, "bound along the axis", "1"), "the bound is"},
      {with_value(good, "K'", slab(1312)), "largest distance along the axis of a child of K_0 from K' is"},
      {with_value(good, "K_0", slab(0)), "Algorithm 2.8 does not subdivide"},
      {with_value(good, "axis", "z"), "largest distance"},
      {with_value(good, "largest distance along the axis of a child of K_0 from K'", "1319/1315"),
       "is 1318/1315, not"}};
  reference::ClaimSubject subject = subject_of(content);
  for (const auto& [witness, reason] : corrupted) {
    const reference::Validation result = reference::validate_claim_witness(subject, "distance-bound", witness);
    EXPECT_FALSE(result.valid) << reason;
    EXPECT_NE(result.report.find(reason), std::string::npos) << reason << " in: " << result.report;
  }
  EXPECT_FALSE(reference::validate_claim_witness(subject, "distance-bound-repaired", good).valid);
}

// 185125 / 116 = 1595.9, below C/3000.
TEST(CorruptedClaimWitness, OfTheExperimentIsRejected) {
  expect_corruptions_rejected(
      "experiment-constant",
      {{"more steps than there are", R"json([{"op":"replace","path":"/values/steps","value":118}])json",
        "not so many steps"},
       {"no step", R"json([{"op":"replace","path":"/values/steps","value":0}])json", "none is asked for"},
       {"the step before, with its true numbers",
        R"json([{"op":"replace","path":"/values/steps","value":116},
            {"op":"replace","path":"/values/new elements","value":185125},
            {"op":"replace","path":"/values/ratio","value":"185125/116"}])json",
        "the ratio is below the bound: 185125/116"},
       {"one element more", R"json([{"op":"replace","path":"/values/new elements","value":186806}])json",
        "the new elements is 186805"},
       {"another ratio", R"json([{"op":"replace","path":"/values/ratio","value":"1597"}])json",
        "the ratio is 186805/117"},
       {"the repaired claim's key", R"json([{"op":"move","from":"/values/C~13000","path":"/values/limit stated"}])json",
        "lacks the key"}});
}

TEST(CorruptedClaimWitness, OfTheLambdaSumIsRejected) {
  expect_corruptions_rejected(
      "lambda-sums",
      {{"a mark too few",
        R"json([{"op":"replace","path":"/values/marks K~0 with lambda(K,K~0) > 0","value":1301}])json",
        "the number of marks with lambda(K,K~) > 0 is 1302"},
       {"another sum", R"json([{"op":"replace","path":"/values/sum","value":"1301/1303"}])json",
        "the sum is 1302/1303"},
       {"an element that is subdivided",
        R"json([{"op":"replace","path":"/values/K","value":{"lower":["2","0","0"],"upper":["3","1","1"],"level":0}}])json",
        "K is no element of the last mesh"},
       {"outside of the domain", R"json([{"op":"replace","path":"/values/K/upper/0","value":"4"}])json",
        "K lies outside of the domain"},
       {"the level off", R"json([{"op":"replace","path":"/values/K/level","value":4}])json", "K: its level is 1"}});
}

// The same witness for a mesh or a sequence that it is not about.
TEST(CorruptedClaimWitness, IsTheWitnessOfAnotherCase) {
  const auto expect = [](const char* claim, const json& witness, const std::string& text, const char* reason) {
    const reference::Validation result = validated(parse_case("asts-case 1\n" + text, "case"), claim, witness);
    EXPECT_FALSE(result.valid) << claim;
    EXPECT_NE(result.report.find(reason), std::string::npos) << result.report;
  };
  const json distance = witness_of("child-distance", finding("child-distance"));
  expect("child-distance", distance, "degree 3 3 3\ngrading 2\ndomain 1 1 1\nrefine 0 0 0\n", "m is 2, not 3");
  expect("child-distance", distance, "degree 3 3 3\ngrading 3\ndomain 1 1 1\n", "K: [0, 1/3]");
  const json far = witness_of("distance-bound", finding("distance-bound"));
  expect("distance-bound", far, "degree 3 3 3\ngrading 1315\ndomain 1 1 1\nrefine 0 0 0\n", "K_0: [1, 2]");
  expect("distance-bound", far, "degree 3 3 3\ngrading 1315\ndomain 2 1 1\nsubdivide 0 0 0\nsubdivide 1314/1315 0 0\n",
         "the mesh is not admissible");
  expect("distance-bound", far, "degree 5 3 3\ngrading 1315\ndomain 2 1 1\nrefine 0 0 0\n", "the bound is");
  const json ratio = witness_of("experiment-constant", finding("experiment-constant"));
  std::string steps;
  for (int n = 0; n < 117; ++n) steps += n == 60 ? "refine 5 5 5\n" : "refine 0 0 0\n";
  expect("experiment-constant", ratio, "degree 3 3 3\ngrading 3\ndomain 5 5 5\n" + steps, "do not mark one corner");
  expect("experiment-constant", ratio, "degree 3 3 3\ngrading 3\ndomain 5 5 6\n" + steps, "setting is not");
  const json sum = witness_of("lambda-sums", finding("lambda-sums"));
  expect("lambda-sums", sum, "degree 3 3 3\ngrading 1303\ndomain 3 1 1\nrefine 5/2 0 0\n",
         "the number of marks with lambda(K,K~) > 0 is 1");
  expect("lambda-sums", sum, "degree 3 3 3\ngrading 1303\ndomain 3 1 1\nsubdivide 5/2 0 0\n", "bare subdivision");
}

}  // namespace
}  // namespace asts::witness_checks
