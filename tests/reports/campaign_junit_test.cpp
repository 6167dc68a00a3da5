#include "reports/campaign_junit.hpp"

#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "lib/mesh/case_file.hpp"
#include "tests/reports/campaign_example.hpp"

namespace asts {
namespace {

pugi::xml_node parsed(pugi::xml_document& document, const std::string& text) {
  const pugi::xml_parse_result read = document.load_buffer(text.data(), text.size());
  EXPECT_TRUE(read) << read.description() << " at " << read.offset << "\n" << text;
  EXPECT_TRUE(text.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n")) << text;
  return document.child("testsuites").child("testsuite");
}

/// "class name: outcome type" of each test case.
std::vector<std::string> outcomes(pugi::xml_node suite) {
  std::vector<std::string> result;
  for (const pugi::xml_node one : suite.children("testcase")) {
    std::string line = std::string(one.attribute("classname").value()) + " " + one.attribute("name").value() + ":";
    for (const pugi::xml_node child : one.children()) {
      line += std::string(" ") + child.name();
      if (child.attribute("type")) line += std::string(" ") + child.attribute("type").value();
    }
    result.push_back(line);
  }
  return result;
}

TEST(CampaignJunit, HasATestCaseForEachClaimAndHealthProblem) {
  const auto [summary, problems] = testing::campaign_example();
  pugi::xml_document document;
  const pugi::xml_node suite = parsed(document, campaign_junit(summary, problems));
  EXPECT_STREQ(suite.attribute("name").value(), "asts campaign");
  EXPECT_EQ(outcomes(suite), (std::vector<std::string>{
                                 "asts.lemma patches-nested:",
                                 "asts.theorem as-implies-dc: system-out",
                                 "asts.theorem as-implies-dc-repaired: failure no-partial-overlap",
                                 "asts.algorithm closure-least: error timeout",
                                 "asts.theorem sigma-unperturbed: skipped",
                                 "asts.campaign outside-of-claims: error crash",
                                 "asts.health hypothesis-never-met sigma-unperturbed: error hypothesis-never-met",
                                 "asts.health trivial-meshes: error trivial-meshes",
                             }));
  EXPECT_EQ(suite.attribute("tests").as_int(), 8);
  EXPECT_EQ(suite.attribute("failures").as_int(), 1);
  EXPECT_EQ(suite.attribute("errors").as_int(), 4);
  EXPECT_EQ(suite.attribute("skipped").as_int(), 1);
}

// Properties, then test cases; of a test case's children at most one outcome, then output.
TEST(CampaignJunit, HasTheOrderAndTheAttributesOfTheSchema) {
  const auto [summary, problems] = testing::campaign_example();
  pugi::xml_document document;
  const pugi::xml_node suite = parsed(document, campaign_junit(summary, problems));
  std::string order;
  for (const pugi::xml_node child : suite.children()) order += child.name() == std::string("testcase") ? "t" : "p";
  EXPECT_EQ(order, "ptttttttt");
  EXPECT_STREQ(suite.child("properties").find_child_by_attribute("name", "seed").attribute("value").value(), "7");
  for (const char* wanted : {"name", "tests", "failures", "errors"}) EXPECT_TRUE(suite.attribute(wanted)) << wanted;
  EXPECT_FALSE(suite.attribute("time"));
  EXPECT_FALSE(suite.attribute("timestamp"));
  for (const pugi::xml_node one : suite.children("testcase")) {
    EXPECT_TRUE(one.attribute("name") && one.attribute("classname"));
    EXPECT_LE(std::distance(one.children().begin(), one.children().end()), 1);
  }
}

TEST(CampaignJunit, TellsTheMinimizedCaseOfAFailure) {
  const auto [summary, problems] = testing::campaign_example();
  pugi::xml_document document;
  const pugi::xml_node suite = parsed(document, campaign_junit(summary, problems));
  const pugi::xml_node failure =
      suite.find_child_by_attribute("testcase", "name", "as-implies-dc-repaired").child("failure");
  EXPECT_STREQ(failure.attribute("message").value(), "as-implies-dc-repaired: no-partial-overlap");
  const std::string text = failure.text().get();
  EXPECT_NE(text.find(write_case(testing::example_case())), std::string::npos) << text;
  EXPECT_NE(text.find("# findings/as-implies-dc-repaired-no-partial-overlap-00ff.case\n"), std::string::npos);
  EXPECT_NE(text.find("v and w share volume\nand do not overlap\n"), std::string::npos);
  const std::string expected =
      suite.find_child_by_attribute("testcase", "name", "as-implies-dc").child("system-out").text().get();
  EXPECT_TRUE(expected.starts_with("violated as expected: the claim is refuted\n"));
}

// An unexpected kind beside an expected one, and a death beside both.
TEST(CampaignJunit, LetsTheWorstFindingOfAClaimDecide) {
  auto [summary, problems] = testing::campaign_example();
  summary.findings[1].claim = "as-implies-dc";
  summary.findings[1].kind = "dropped-pair";
  pugi::xml_document document;
  EXPECT_EQ(outcomes(parsed(document, campaign_junit(summary, problems)))[1],
            "asts.theorem as-implies-dc: failure dropped-pair");
  summary.findings[2].claim = "as-implies-dc";
  EXPECT_EQ(outcomes(parsed(document, campaign_junit(summary, problems)))[1],
            "asts.theorem as-implies-dc: error timeout");
}

TEST(CampaignJunit, StaysXmlWhateverTheTextsHold) {
  const auto [summary, problems] = testing::hostile_example();
  const std::string text = campaign_junit(summary, problems);
  for (const char c : text) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << int{c};
  EXPECT_EQ(text.find("&#"), std::string::npos) << "a reference to a control character is no XML either";
  EXPECT_EQ(text.find('\xFF'), std::string::npos);
  pugi::xml_document document;
  const pugi::xml_node suite = parsed(document, text);
  EXPECT_EQ(outcomes(suite).size(), 8U);
  const std::string failure =
      suite.find_child_by_attribute("testcase", "name", "as-implies-dc-repaired").child("failure").text().get();
  EXPECT_NE(failure.find("<a b=\"c\">&]]> \\ "), std::string::npos) << failure;
}

}  // namespace
}  // namespace asts
