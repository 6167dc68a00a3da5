#include "reports/campaign_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lib/mesh/case_file.hpp"
#include "reports/ledger_report.hpp"
#include "tests/reports/campaign_example.hpp"

namespace asts {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

TEST(CampaignJson, HasEverythingInAFixedOrder) {
  const auto [summary, problems] = testing::campaign_example();
  const std::string text = campaign_json(summary, problems);
  EXPECT_TRUE(text.starts_with("{\n  \"version\": \"1.2.3\",\n  \"claims\": [\n    \"patches-nested\",\n")) << text;
  EXPECT_TRUE(text.ends_with("\n}\n"));
  const Json json = Json::parse(text);
  EXPECT_EQ(keys_of(json), (std::vector<std::string>{"version", "claims", "seed", "cases", "meshes", "distinct",
                                                     "trivial", "sequences", "deaths", "biases", "generated", "records",
                                                     "findings", "healthy", "health"}));
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["cases"], 20);
  EXPECT_EQ(json["meshes"], 60);
  EXPECT_EQ(json["distinct"], 50);
  EXPECT_EQ(json["trivial"], 9);
  EXPECT_EQ(json["sequences"], 6);
  EXPECT_EQ(json["deaths"], 0);
  EXPECT_EQ(json["biases"].dump(), R"({"boxes-cut":0,"marks-deep":20})");
  EXPECT_EQ(json["generated"].dump(), R"({"elements":{"128":20,"1024":30},"level":{"0":9,"2":41}})");
  EXPECT_EQ(json["healthy"], false);
  EXPECT_EQ(json["health"][1].dump(), R"({"check":"trivial-meshes","subject":"","says":"30 of 50"})");
}

TEST(CampaignJson, HasRecordsAsTheLedgerDoes) {
  const auto [summary, problems] = testing::campaign_example();
  const Json json = Json::parse(campaign_json(summary, problems));
  ASSERT_EQ(json["records"].size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    Json record = json["records"][i];
    EXPECT_FALSE(record.contains("smallest"));
    record["smallest"] = nullptr;
    EXPECT_EQ(record.dump() + "\n", ledger_json(summary.records[i]));
  }
}

TEST(CampaignJson, HasFindingsWithTheirCases) {
  const auto [summary, problems] = testing::campaign_example();
  const Json findings = Json::parse(campaign_json(summary, problems))["findings"];
  ASSERT_EQ(findings.size(), 4U);
  EXPECT_EQ(keys_of(findings[0]), (std::vector<std::string>{"claim", "kind", "expected", "number", "step", "minimized",
                                                            "file", "says", "valid", "validation", "case"}));
  EXPECT_EQ(findings[0]["expected"], true);
  EXPECT_EQ(findings[1]["expected"], false);
  EXPECT_EQ(findings[1]["number"], 17);
  EXPECT_EQ(findings[1]["minimized"]["size"]["subdivisions"], 2);
  EXPECT_EQ(findings[1]["minimized"]["guarantee"], "1-minimal");
  EXPECT_EQ(findings[1]["minimized"]["evaluations"], 123);
  EXPECT_EQ(findings[1]["valid"], true);
  EXPECT_EQ(parse_case(findings[1]["case"].get<std::string>(), "case"), testing::example_case());
  EXPECT_TRUE(findings[2]["minimized"].is_null());
  EXPECT_TRUE(findings[2]["valid"].is_null());
  CampaignSummary alone = summary;
  alone.findings.front().content.reset();
  alone.findings.front().minimized.reset();
  alone.findings.front().number.reset();
  const Json finding = Json::parse(campaign_json(alone, {}))["findings"][0];
  EXPECT_TRUE(finding["case"].is_null());
  EXPECT_TRUE(finding["number"].is_null());
  EXPECT_EQ(Json::parse(campaign_json(alone, {}))["healthy"], true);
}

TEST(CampaignJson, StaysJsonWhateverTheTextsHold) {
  const auto [summary, problems] = testing::hostile_example();
  const Json json = Json::parse(campaign_json(summary, problems));
  const std::string says = json["findings"][0]["says"];
  EXPECT_NE(says.find("\x01\x1b[31m \xEF\xBF\xBD "), std::string::npos);
  EXPECT_NE(says.find("<a b=\"c\">&]]> \\ "), std::string::npos);
}

}  // namespace
}  // namespace asts
