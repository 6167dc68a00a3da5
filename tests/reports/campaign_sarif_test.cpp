#include "reports/campaign_sarif.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/reports/campaign_example.hpp"

namespace asts {
namespace {

using Json = nlohmann::ordered_json;

Json sarif_of(const testing::CampaignExample& example) {
  return Json::parse(campaign_sarif(example.summary, example.problems));
}

/// The object has the keys that the schema requires, and none that it does not know.
void expect_keys(const Json& json, const std::set<std::string>& required, const std::set<std::string>& others) {
  ASSERT_TRUE(json.is_object()) << json;
  for (const std::string& key : required) EXPECT_TRUE(json.contains(key)) << key << " is missing in " << json;
  for (const auto& [key, value] : json.items()) {
    EXPECT_TRUE(required.contains(key) || others.contains(key)) << key << " is not known in " << json;
  }
}

// sarif-schema-2.1.0: what it requires of the objects that occur here, and the types and enumerations.
void expect_valid(const Json& sarif) {
  expect_keys(sarif, {"version", "runs"}, {"$schema"});
  EXPECT_EQ(sarif["version"], "2.1.0");
  ASSERT_EQ(sarif["runs"].size(), 1U);
  const Json& run = sarif["runs"][0];
  expect_keys(run, {"tool"}, {"invocations", "results"});
  expect_keys(run["tool"], {"driver"}, {});
  expect_keys(run["tool"]["driver"], {"name"}, {"version", "rules"});
  for (const Json& rule : run["tool"]["driver"]["rules"]) {
    expect_keys(rule, {"id"}, {"shortDescription", "properties"});
    expect_keys(rule["shortDescription"], {"text"}, {});
  }
  ASSERT_TRUE(run["invocations"].is_array());
  for (const Json& invocation : run["invocations"]) {
    expect_keys(invocation, {"executionSuccessful"}, {"toolExecutionNotifications"});
    EXPECT_TRUE(invocation["executionSuccessful"].is_boolean());
    for (const Json& notification : invocation["toolExecutionNotifications"]) {
      expect_keys(notification, {"message"}, {"descriptor", "level"});
      expect_keys(notification["message"], {"text"}, {});
      expect_keys(notification["descriptor"], {"id"}, {});
    }
  }
  for (const Json& result : run["results"]) {
    expect_keys(result, {"message"}, {"ruleId", "ruleIndex", "level", "locations", "partialFingerprints"});
    expect_keys(result["message"], {"text"}, {});
    EXPECT_TRUE((std::set<std::string>{"none", "note", "warning", "error"}.contains(result["level"])));
    EXPECT_EQ(run["tool"]["driver"]["rules"][result["ruleIndex"].get<std::size_t>()]["id"], result["ruleId"]);
    ASSERT_TRUE(result["locations"].is_array());
    for (const auto& [name, value] : result["partialFingerprints"].items()) EXPECT_TRUE(value.is_string());
  }
}

TEST(CampaignSarif, HasTheStructureOfTheSchema) {
  expect_valid(sarif_of(testing::campaign_example()));
  expect_valid(sarif_of({}));
  EXPECT_EQ(sarif_of({})["runs"][0]["results"], Json::array());
}

TEST(CampaignSarif, HasARuleForEachClaim) {
  const Json rules = sarif_of(testing::campaign_example())["runs"][0]["tool"]["driver"]["rules"];
  ASSERT_EQ(rules.size(), 6U);
  EXPECT_EQ(rules[1]["id"], "as-implies-dc");
  EXPECT_EQ(rules[1]["properties"].dump(),
            R"({"kind":"theorem","source":"Theorem 6.6, AS within DC","status":"refuted"})");
  EXPECT_EQ(rules[1]["shortDescription"]["text"], find_claim("as-implies-dc")->statement);
  EXPECT_EQ(rules[5]["id"], "outside-of-claims");
}

TEST(CampaignSarif, HasAResultForEachFinding) {
  const Json results = sarif_of(testing::campaign_example())["runs"][0]["results"];
  ASSERT_EQ(results.size(), 4U);
  const std::vector<std::string> levels{"note", "error", "error", "error"};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(results[i]["level"], levels[i]);
  EXPECT_EQ(results[1]["ruleId"], "as-implies-dc-repaired");
  EXPECT_EQ(
      results[1]["locations"].dump(),
      R"([{"physicalLocation":{"artifactLocation":{"uri":"findings/as-implies-dc-repaired-no-partial-overlap-00ff.case"}}}])");
  EXPECT_EQ(results[1]["partialFingerprints"].dump(),
            R"({"claimKindCase/v1":"as-implies-dc-repaired-no-partial-overlap-00ff"})");
  const std::string message = results[1]["message"]["text"];
  EXPECT_TRUE(message.starts_with("as-implies-dc-repaired: no-partial-overlap\n2 subdivisions, 2 steps")) << message;
  EXPECT_EQ(results[3]["ruleId"], "outside-of-claims");
}

TEST(CampaignSarif, HasNoPlaceForAFindingWithoutACase) {
  testing::CampaignExample example = testing::campaign_example();
  CampaignFinding& finding = example.summary.findings.front();
  finding.content.reset();
  finding.minimized.reset();
  finding.file.clear();
  const Json result = sarif_of(example)["runs"][0]["results"][0];
  expect_valid(sarif_of(example));
  EXPECT_EQ(result["locations"], Json::array());
  EXPECT_EQ(result["partialFingerprints"]["claimKindCase/v1"], "as-implies-dc-no-partial-overlap");
}

TEST(CampaignSarif, SaysWhetherTheCampaignWasHealthy) {
  testing::CampaignExample example = testing::campaign_example();
  Json invocation = sarif_of(example)["runs"][0]["invocations"][0];
  EXPECT_EQ(invocation["executionSuccessful"], false);
  EXPECT_EQ(invocation["toolExecutionNotifications"][0].dump(),
            R"({"descriptor":{"id":"hypothesis-never-met"},"level":"error","message":{"text":)"
            R"("sigma-unperturbed: its hypothesis was met in none of 40 trials"}})");
  example.problems.clear();
  invocation = sarif_of(example)["runs"][0]["invocations"][0];
  EXPECT_EQ(invocation["executionSuccessful"], true);
  EXPECT_EQ(invocation["toolExecutionNotifications"], Json::array());
}

TEST(CampaignSarif, StaysJsonWhateverTheTextsHold) {
  const Json sarif = sarif_of(testing::hostile_example());
  expect_valid(sarif);
  const std::string message = sarif["runs"][0]["results"][0]["message"]["text"];
  EXPECT_NE(message.find("\xEF\xBF\xBD[31m"), std::string::npos) << message;
}

}  // namespace
}  // namespace asts
