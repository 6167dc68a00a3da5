#include "reports/witness_reading.hpp"

#include <gtest/gtest.h>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "properties/statement.hpp"
#include "reports/witness_json.hpp"
#include "tests/reports/collected_cases.hpp"

namespace asts {
namespace {

using Json = nlohmann::ordered_json;

// The law, on every kind of witness that the collection and the findings have.
TEST(WitnessReading, GivesTheJsonBack) {
  std::size_t read = 0;
  testing::for_each_collected([&](const std::string& name, const Case& content, const Statement& statement) {
    const Trial trial = try_on_case(statement, content);
    if (!trial.verdict.witness) return;
    const Json json = witness_json(*trial.verdict.witness);
    EXPECT_EQ(witness_json(witness_from_json(json)).dump(), json.dump()) << name;
    EXPECT_EQ(kind_of(witness_from_json(json)), kind_of(*trial.verdict.witness));
    const Json verdict = verdict_json(trial.verdict);
    EXPECT_EQ(verdict_json(verdict_from_json(verdict)).dump(), verdict.dump());
    ++read;
  });
  EXPECT_GT(read, 15U);
}

TEST(WitnessReading, ReadsIrrationalValues) {
  const auto field = std::make_shared<const CosineField>(4);
  ClaimWitness witness{"kind", "says", {}};
  witness.values = {{"value", FieldElement(field, std::vector<Rational>{Rational(1, 2), Rational(3)})},
                    {"rational", FieldElement(field, Rational(1, 3))},
                    {"count", std::int64_t{-4}},
                    {"list", std::vector<Rational>{}},
                    {"text", std::string("x = 5/2")}};
  const Json json = witness_json(witness);
  EXPECT_EQ(witness_json(witness_from_json(json)), json);
}

void expect_rejected(const char* text) {
  EXPECT_THROW(static_cast<void>(witness_from_json(Json::parse(text))), InputError) << text;
}

TEST(WitnessReading, RefusesWhatIsNone) {
  expect_rejected("[]");
  expect_rejected("{}");
  expect_rejected(R"({"kind":"none"})");
  expect_rejected(R"({"kind":3,"says":"","values":{}})");
  expect_rejected(R"({"kind":"k","says":"s","values":{"a":1.5}})");
  expect_rejected(R"({"kind":"k","says":"s","values":{"a":["1","x"]}})");
  expect_rejected(R"({"kind":"k","says":"s","values":{"a":["2/4","1"]}})");
  expect_rejected(R"({"kind":"k","says":"s","values":{},"more":1})");
  expect_rejected(R"({"kind":"outside-class","element":{"lower":["0","0"],"upper":["1","1","1"],"level":0}})");
  // a field so large that its polynomial would take forever
  expect_rejected(
      R"x({"kind":"k","says":"s","values":{"a":{"coefficients":["0","1"],"generator":"2*cos(pi/2000000000)"}}})x");
}

TEST(VerdictReading, RefusesWhatIsNone) {
  for (const char* text : {"1", "{}", R"({"verdict":"perhaps"})", R"({"verdict":"holds","reason":4})"}) {
    EXPECT_THROW(static_cast<void>(verdict_from_json(Json::parse(text))), InputError) << text;
  }
}

TEST(CountReading, TakesCountsAlone) {
  const Json json = Json::parse(R"({"a":3,"b":-1,"c":1.0,"d":"1","e":18446744073709551615})");
  EXPECT_EQ(count_in(json, "a"), 3);
  for (const char* member : {"b", "c", "d", "e", "f"}) {
    EXPECT_THROW(static_cast<void>(count_in(json, member)), InputError) << member;
  }
}

}  // namespace
}  // namespace asts
