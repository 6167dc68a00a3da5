#include "reports/html/campaign_page.hpp"

#include <gtest/gtest.h>

#include "tests/reports/campaign_example.hpp"
#include "tests/reports/html_page.hpp"

namespace asts {
namespace {

using testing::HtmlPage;

CampaignRecords records_of(const testing::CampaignExample& example) {
  CampaignRecords records;
  records.summary = example.summary;
  records.health = example.problems;
  records.cases_asked = 20;
  records.minimize_budget = 5000;
  records.stored = {"one.case"};
  for (const CampaignFinding& finding : example.summary.findings) {
    records.details.push_back({{{finding.number, finding.step, 11, 5, "1-minimal"}, {18, 2, 12, 6, "budget"}},
                               {},
                               82,
                               4,
                               {{"drop-elements", 3, false}},
                               {{"other-kind", "asts-case 1\n"}}});
  }
  records.units = {{0, "cases 0 to 19", 20, 60, 50, 9, 6, {"as-implies-dc: 3 no-partial-overlap"}}};
  records.times = {{0, 1'500'000, 90'000, 17, {1, 2, 3, 4, 5}}};
  records.differences = {"statistics.json is missing"};
  return records;
}

/// The text of a page without what is between tags.
bool shows(const std::string& page, const std::string& text) { return page.find(text) != std::string::npos; }

TEST(CampaignPage, HasEverything) {
  const std::string page = campaign_page(records_of(testing::campaign_example()), "4.5.6");
  const HtmlPage html(page);
  for (const char* id : {"summary", "claims", "findings", "generated", "performance", "about", "finding-1", "finding-4",
                         "view-1", "view-2", "claims-table", "generated-level", "generated-elements", "units-table",
                         "times-table", "statement-as-implies-dc", "finding-1-origins", "finding-1-passes"}) {
    EXPECT_TRUE(html.document().find_node([&](const pugi::xml_node& node) {
      return std::string_view(node.attribute("id").value()) == id;
    })) << id;
  }
  EXPECT_TRUE(shows(page, "1.2.3"));
  EXPECT_TRUE(shows(page, "4.5.6"));
  EXPECT_TRUE(
      shows(page, "asts check --final --claim as-implies-dc findings/as-implies-dc-no-partial-overlap-00ff.case"));
  EXPECT_TRUE(shows(page, "Theorem 6.6, AS within DC"));
  EXPECT_TRUE(shows(page, "2 subdivisions, 2 steps, 4 x 4 x 5 cubes, p = (3,3,3), m = 2, level 2"));
  EXPECT_TRUE(shows(page, "statistics.json is missing"));
  EXPECT_TRUE(shows(page, "its hypothesis was met in none of 40 trials"));
  EXPECT_TRUE(shows(page, "1.500000 s"));
  EXPECT_TRUE(shows(page, "4 findings, 3 of them unexpected."));
}

TEST(CampaignPage, HasTheSameBytesAgain) {
  const CampaignRecords records = records_of(testing::campaign_example());
  EXPECT_EQ(campaign_page(records, "1"), campaign_page(records, "1"));
}

TEST(CampaignPage, EscapesWhateverTheTextsHold) {
  CampaignRecords records = records_of(testing::hostile_example());
  const std::string hostile = "<script>alert(1)</script><img src=\"http://x\" onerror='y'>]]>&amp; --> \x01\xff\"";
  records.units[0].what = hostile;
  records.units[0].events = {hostile};
  records.differences = {hostile};
  records.stored = {hostile};
  records.details[0].others = {{hostile, hostile}};
  records.details[0].last_run[0].name = hostile;
  records.summary.biases[hostile] = 3;
  records.summary.records[0].biases[hostile] = 3;
  const std::string page = campaign_page(records, hostile);
  const HtmlPage html(page);
  EXPECT_FALSE(shows(page, "<script>alert"));
  EXPECT_FALSE(shows(page, "<img"));
  EXPECT_TRUE(shows(page, "&lt;script&gt;alert(1)"));
}

TEST(CampaignPage, GroupsManyUnits) {
  CampaignRecords records = records_of(testing::campaign_example());
  const CampaignRecords::Unit unit = records.units[0];
  const CampaignRecords::Times times = records.times[0];
  for (std::int64_t number = 1; number < 1000; ++number) {
    records.units.push_back(unit);
    records.units.back().number = number;
    records.times.push_back(times);
    records.times.back().unit = number;
  }
  const HtmlPage html(campaign_page(records, "1"));
  const auto rows = [&](const char* id) {
    return html.document().select_nodes((std::string("//table[caption/@id='") + id + "']/tbody/tr").c_str()).size();
  };
  EXPECT_EQ(rows("units-table"), 200U);
  EXPECT_EQ(rows("times-table"), 200U);
}

TEST(CampaignPage, DrawsNoCaseThatTheCodeDidNotComeBackFrom) {
  testing::CampaignExample example = testing::campaign_example();
  example.summary.findings = {testing::example_death("closure-least", "timeout")};
  const HtmlPage html(campaign_page(records_of(example), "1"));
  EXPECT_TRUE(html.document().select_nodes("//figure").empty());
}

}  // namespace
}  // namespace asts
