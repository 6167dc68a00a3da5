#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "properties/claims/claim.hpp"
#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

using Names = std::vector<std::string>;
using Json = nlohmann::ordered_json;

const Names kSome{"ledger", "--claim", "as-implies-dc", "--claim", "dc-implies-as", "--cases", "60"};

Outcome run_with(Names arguments, const Names& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments);
}

TEST(LedgerCommand, WritesOneRecordAClaim) {
  const Outcome outcome = run_with(kSome, {"--format", "json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const auto records = records_of(outcome.out);
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0]["claim"], "as-implies-dc");
  EXPECT_EQ(records[1]["claim"], "dc-implies-as");
  for (const Json& record : records) {
    const Names keys{"claim",  "status",   "result",         "meshes",    "sequences", "alone",
                     "holds",  "violated", "not_applicable", "undecided", "met",       "trials_met",
                     "bounds", "biases",   "features",       "smallest"};
    Names found = keys_of(record);
    std::erase(found, "says");
    EXPECT_EQ(found, keys);
    EXPECT_EQ(record["meshes"], records[0]["meshes"]);
    const auto count = [&](const char* key) { return record[key].get<std::int64_t>(); };
    EXPECT_EQ(count("holds") + count("violated") + count("not_applicable") + count("undecided"), count("meshes"));
    EXPECT_GE(count("meshes"), 100);
    EXPECT_GT(count("met"), 0);
  }
}

TEST(LedgerCommand, GivesTheSameBytesForASeedWhateverTheJobs) {
  const std::string one = run_with(kSome, {"--format", "json"}).out;
  EXPECT_EQ(run_with(kSome, {"--format", "json", "--seed", "1"}).out, one);
  for (const char* jobs : {"2", "5"}) EXPECT_EQ(run_with(kSome, {"--format", "json", "--jobs", jobs}).out, one);
  EXPECT_NE(run_with(kSome, {"--format", "json", "--seed", "2"}).out, one);
}

TEST(LedgerCommand, ShowsATable) {
  const Names lines = lines_of(run_with(kSome, {}).out);
  ASSERT_GE(lines.size(), 3U);
  EXPECT_TRUE(lines[0].starts_with("claim "));
  EXPECT_TRUE(lines[1].starts_with("as-implies-dc "));
  EXPECT_TRUE(lines[2].starts_with("dc-implies-as "));
}

// A run that never met a hypothesis is no pass.
TEST(LedgerCommand, SaysUndecidedWhenNothingWasTried) {
  const Outcome outcome = run({"ledger", "--claim", "as-implies-dc", "--cases", "0", "--format", "json"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(records_of(outcome.out)[0]["result"], "undecided");
}

TEST(LedgerCommand, RendersRecordsAsMarkdown) {
  const TemporaryFolder folder;
  const std::string written = run_with(kSome, {"--format", "json"}).out;
  const std::string path = folder.write("ledger.jsonl", written);
  const Json record = records_of(written)[0];
  const std::string exhaustive =
      R"({"degree":[3,3,3],"grading":2,"domain":[4,4,5],"max_subdivisions":3,"admissible":true,"claim":"as-implies-dc",)"
      R"("meshes":85401,"violations":0,"smallest":null,"applicable":85400,"not_applicable":1,"undecided":0,"met":7})";
  const std::string other = folder.write("enumerate.jsonl", exhaustive + "\n");
  const Outcome outcome = run({"ledger", "--render", path, other});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Names lines = lines_of(outcome.out);
  const auto has_line = [&](const std::string& begin) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) { return line.starts_with(begin); });
  };
  const std::string status = record["status"];
  const std::string result = record["result"];
  EXPECT_TRUE(has_line("| `as-implies-dc` | " + status + " | " + result + " | " + record["meshes"].dump() + " | 0 | "));
  EXPECT_TRUE(has_line("| `as-implies-dc` | 3 3 3 | 2 | 4 4 5 | 3, admissible | 85401 | 85400 | 0 |"));
  EXPECT_TRUE(has_line("| `dc-implies-as` | "));
}

TEST(LedgerCommand, RejectsWhatItCannotDo) {
  const TemporaryFolder folder;
  const std::string garbage = folder.write("garbage", "\nno json\n");
  const std::pair<Names, std::string> faults[] = {
      {{"ledger", "--claim", "none"}, "asts: no claim is called 'none'"},
      {{"ledger", "--cases", "-1"}, "asts: "},
      {{"ledger", "--jobs", "0"}, "asts: "},
      {{"ledger", "--render", folder.path("missing")}, "asts: " + folder.path("missing") + ": cannot be read"},
      {{"ledger", "--render", garbage}, "asts: " + garbage + ":1: "},
  };
  for (const auto& [arguments, reason] : faults) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << reason;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with(reason)) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U);
  }
}

// What has been done is printed, by one process and by several.
TEST(LedgerCommand, PrintsItsRecordsWhenInterrupted) {
  for (const char* jobs : {"1", "2"}) {
    Process process({"ledger", "--claim", "as-implies-dc", "--cases", "100000000", "--format", "json", "--jobs", jobs});
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    kill(process.id(), SIGINT);
    const Outcome outcome = process.wait();
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(outcome.err, "");
    const auto records = records_of(outcome.out);
    ASSERT_EQ(records.size(), 1U);
    EXPECT_GT(records[0]["meshes"], 0);
  }
}

// The result of `asts claims` says how far each claim was tried.
TEST(ClaimsCommand, SaysHowFarEachClaimWasTried) {
  const auto records = records_of(run({"claims", "--format", "json"}).out);
  ASSERT_EQ(records.size(), all_claims().size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i]["id"], all_claims()[i].id);
    ASSERT_TRUE(records[i].contains("tried")) << all_claims()[i].id;
    if (records[i]["tried"].is_null()) continue;
    const Names keys{"trials", "meshes", "sequences", "met", "trials_met", "violated", "bounds", "exhaustive"};
    EXPECT_EQ(keys_of(records[i]["tried"]), keys);
  }
}

}  // namespace
}  // namespace asts::testing
