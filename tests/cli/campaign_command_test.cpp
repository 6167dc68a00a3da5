#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

Outcome campaign(Names arguments) {
  arguments.insert(arguments.begin(), "campaign");
  return run(arguments);
}

// "A refuted claim was expected to hold": named, it is.
TEST(CampaignCommand, SaysWhetherWhatWasExpectedHolds) {
  EXPECT_EQ(campaign({"--claim", "as-implies-dc", "--cases", "64"}).exit_code, 1);
  EXPECT_EQ(campaign({"--claim", "as-implies-dc-repaired", "--cases", "64"}).exit_code, 0);
}

TEST(CampaignCommand, SaysThatAResultIsHollow) {
  // one case does not meet its hypothesis
  const Outcome outcome = campaign({"--claim", "as-implies-dc-repaired", "--cases", "1", "--format", "json"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.out.find("hypothesis-never-met"), std::string::npos) << outcome.out;
}

TEST(CampaignCommand, WritesTheRunDirectory) {
  const TemporaryFolder folder;
  const std::string out = folder.path("run");
  const Outcome outcome = campaign({"--claim", "as-implies-dc", "--cases", "128", "--out", out, "--format", "json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  for (const char* name : {"units.jsonl", "findings.jsonl", "times.jsonl", "statistics.json", "statistics.txt",
                           "junit.xml", "results.sarif"}) {
    EXPECT_TRUE(fs::exists(out + "/" + name)) << name;
  }
  EXPECT_EQ(content_of(out + "/statistics.json"), outcome.out);
  const auto statistics = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(statistics.at("cases"), 128);
  const auto finding = statistics.at("findings").at(0);
  EXPECT_EQ(finding.at("claim"), "as-implies-dc");
  const std::string file = out + "/" + finding.at("file").get<std::string>();
  EXPECT_EQ(run({"check", "--final", "--claim", "as-implies-dc", file}).exit_code, 1);
  const Outcome validated = run({"validate", out + "/findings.jsonl"});
  EXPECT_EQ(validated.exit_code, 0) << validated.out;
  EXPECT_EQ(run({"replay", out + "/findings"}).exit_code, 0);
}

TEST(CampaignCommand, GoesOnAsItWasBegun) {
  const TemporaryFolder folder;
  const std::string out = folder.path("run");
  const Names begun{"--claim", "as-implies-dc", "--seed", "9", "--out", out};
  Names longer = begun;
  longer.insert(longer.end(), {"--cases", "64"});
  EXPECT_EQ(campaign(longer).exit_code, 1);
  const Outcome again = campaign(begun);
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_EQ(again.err, "asts: " + out + ": has a campaign already; --resume goes on with it\n");
  const Outcome same = campaign({"--out", out, "--resume", "--format", "json"});
  EXPECT_EQ(same.exit_code, 1) << same.err;  // the claim was named then
  EXPECT_EQ(nlohmann::json::parse(same.out).at("cases"), 64);
  EXPECT_EQ(nlohmann::json::parse(same.out).at("seed"), 9);
  const Outcome more = campaign({"--out", out, "--resume", "--cases", "100", "--format", "json"});
  EXPECT_EQ(nlohmann::json::parse(more.out).at("cases"), 100);
  const Outcome other = campaign({"--out", out, "--resume", "--seed", "10"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_EQ(other.err, "asts: " + out + ": was begun by another version, or with other claims, seed or stored cases\n");
}

TEST(CampaignCommand, RefusesWhatItCannotDo) {
  const TemporaryFolder folder;
  const auto refusal = [](const Names& arguments) {
    const Outcome outcome = campaign(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  EXPECT_EQ(refusal({"--resume"}), "asts: --resume needs --out\n");
  EXPECT_NE(refusal({"--claim", "none"}).find("none"), std::string::npos);
  EXPECT_NE(refusal({"--cases", "0"}).find("--cases"), std::string::npos);
  EXPECT_NE(refusal({"--cases", "5", "--time", "5"}).find("--time"), std::string::npos);
  EXPECT_NE(refusal({"--jobs", "0"}).find("--jobs"), std::string::npos);
  EXPECT_NE(refusal({"--replay", folder.path("none")}).find("is no folder"), std::string::npos);
  const std::string file = folder.write("file", "");
  EXPECT_NE(refusal({"--out", file + "/run"}).find("cannot be made"), std::string::npos);
  EXPECT_NE(refusal({"--timeout", "10000000000"}).find("--timeout"), std::string::npos);
  EXPECT_NE(refusal({"--time", "10000000000"}).find("--time"), std::string::npos);
  EXPECT_NE(refusal({"--cases", "9223372036854775807"}).find("--cases"), std::string::npos);
  folder.write("units.jsonl", "{}\n");
  EXPECT_EQ(refusal({"--out", folder.path("")}),
            "asts: " + folder.path("") + "/units.jsonl:1: no plan of a campaign\n");
}

TEST(CampaignCommand, ReplaysACollectionFirst) {
  const std::string collection = std::string(ASTS_CASES) + "/../../reports/collection";
  const Outcome outcome =
      campaign({"--claim", "as-implies-dc-repaired", "--cases", "64", "--replay", collection, "--format", "json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  const Outcome theorem =
      campaign({"--claim", "as-implies-dc", "--cases", "2", "--replay", collection, "--format", "json"});
  EXPECT_EQ(nlohmann::json::parse(theorem.out).at("biases").at("stored"), 1);
  EXPECT_EQ(nlohmann::json::parse(theorem.out).at("findings").size(), 0U);
}

TEST(CampaignCommand, KeepsWhatWasDoneWhenInterrupted) {
  const TemporaryFolder folder;
  const std::string out = folder.path("run");
  Process process({"campaign", "--claim", "as-implies-dc", "--cases", "10000000", "--out", out, "--format", "json"});
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  kill(process.id(), SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 130);
  const auto statistics = nlohmann::json::parse(outcome.out);
  EXPECT_GT(statistics.at("cases"), 0);
  EXPECT_LT(statistics.at("cases"), 10000000);
  EXPECT_EQ(content_of(out + "/statistics.json"), outcome.out);
}

}  // namespace
}  // namespace asts::testing
