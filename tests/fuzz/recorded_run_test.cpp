#include "fuzz/campaign/recorded_run.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "fuzz/campaign/campaign.hpp"
#include "fuzz/campaign/sealed_lines.hpp"
#include "lib/exact/errors.hpp"
#include "properties/campaign/health.hpp"
#include "reports/campaign_json.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/reports/record_numbers.hpp"

namespace asts::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

/// One claim that case 7 violates, in few cases: a directory with few numbers.
CampaignPlan small_plan() {
  CampaignPlan plan;
  plan.claims = {find_claim("as-implies-dc")};
  plan.version = "test";
  return plan;
}

class RecordedRun : public ::testing::Test {
 protected:
  void SetUp() override {
    CampaignRun how;
    how.cases = 10;
    RunDirectory directory(run_, false);
    const CampaignResult result = run_campaign(small_plan(), how, &directory);
    directory.write_file("statistics.json", campaign_json(result.summary, check_health(result.summary)));
    page_ = page();
  }

  std::string page() const { return campaign_page(read_recorded_run(run_), "test"); }
  std::string file(const std::string& name) const { return run_ + "/" + name; }
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(file(name), std::ios::binary) << content;
  }

  /// What is wrong with the directory; empty when nothing is.
  std::string reason() const {
    try {
      page();
      return "";
    } catch (const InputError& error) {
      return error.what();
    }
  }

  TemporaryFolder folder_;
  std::string run_ = folder_.path("run");
  std::string page_;
};

/// Without the digits of places in lists.
std::string name_of(const std::string& file, const Pointer& place) {
  std::string name = file;
  for (Pointer left = place; !left.empty(); left.pop_back()) {
    const std::string part = left.back();
    const bool digits = part.find_first_not_of("0123456789") == std::string::npos;
    name.insert(file.size(), "/" + (digits ? "*" : part));
  }
  return name;
}

// The law: whatever number of a record is changed, the page is another one. What contradicts the rest is an error.
TEST_F(RecordedRun, EveryNumberOfARecordIsSeenInThePage) {
  std::set<std::string> rejected;
  std::size_t tried = 0;
  for (const char* name : {"units.jsonl", "findings.jsonl", "times.jsonl"}) {
    const std::string whole = content_of(file(name));
    const std::vector<std::string> lines = lines_of(whole);
    ASSERT_FALSE(lines.empty()) << name;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Json record = Json::parse(unsealed(lines[i]).value());
      for (const Pointer& place : numbers_of(record)) {
        Json other = record;
        other[place] = changed_number(record[place]);
        std::string content;
        for (std::size_t j = 0; j < lines.size(); ++j) content += (j == i ? sealed(other.dump()) : lines[j]) + "\n";
        write(name, content);
        ++tried;
        try {
          EXPECT_TRUE(page() != page_) << name << ":" << i + 1 << ": " << place.to_string();
        } catch (const InputError& error) {
          EXPECT_TRUE(std::string(error.what()).starts_with(file(name) + ":" + std::to_string(i + 1) + ": "))
              << error.what();
          rejected.insert(name_of(name, place));
        }
      }
    }
    write(name, whole);
  }
  EXPECT_GT(tried, 150U);
  EXPECT_EQ(rejected, (std::set<std::string>{"findings.jsonl/size/degree/*", "findings.jsonl/size/domain/*",
                                             "findings.jsonl/step", "findings.jsonl/task",
                                             "findings.jsonl/witness_format", "units.jsonl/campaign",
                                             "units.jsonl/cases", "units.jsonl/end", "units.jsonl/unit"}));
  EXPECT_EQ(page(), page_);
}

// The statistics say again what the records say: where they do not, the page says so.
TEST_F(RecordedRun, EveryNumberOfTheStatisticsIsCompared) {
  const Json statistics = Json::parse(content_of(file("statistics.json")));
  const std::vector<Pointer> numbers = numbers_of(statistics);
  EXPECT_GT(numbers.size(), 50U);
  for (const Pointer& place : numbers) {
    Json other = statistics;
    other[place] = changed_number(statistics[place]);
    write("statistics.json", other.dump(2) + "\n");
    EXPECT_EQ(read_recorded_run(run_).differences.size(), 1U) << place.to_string();
  }
  EXPECT_NE(page(), page_);
  EXPECT_NE(page().find("do not say what its records say"), std::string::npos);
}

TEST_F(RecordedRun, ReadsWhatTheCampaignWrote) {
  const CampaignRecords records = read_recorded_run(run_);
  EXPECT_EQ(records.summary.cases, 10);
  EXPECT_EQ(records.cases_asked, 10);
  EXPECT_EQ(records.differences, std::vector<std::string>{});
  ASSERT_EQ(records.summary.findings.size(), 1U);
  ASSERT_EQ(records.details.size(), 1U);
  ASSERT_TRUE(records.details[0].witness);
  EXPECT_EQ(kind_of(*records.details[0].witness), "no-partial-overlap");
  EXPECT_EQ(records.details[0].elements, 82);
  EXPECT_EQ(records.units.size(), 1U);
  EXPECT_EQ(records.times.size(), 1U);
}

TEST_F(RecordedRun, SaysWhichLineIsCutOffOrDamaged) {
  for (const char* name : {"units.jsonl", "findings.jsonl", "times.jsonl"}) {
    const std::string whole = content_of(file(name));
    const std::size_t lines = lines_of(whole).size();
    for (const std::size_t cut : {std::size_t{1}, std::size_t{2}, std::size_t{40}}) {
      write(name, whole.substr(0, whole.size() - cut));
      EXPECT_EQ(reason(), file(name) + ":" + std::to_string(lines) + ": the record is cut off or damaged");
    }
    write(name, whole);
  }
  write("units.jsonl", "");
  EXPECT_EQ(reason(), file("units.jsonl") + ":1: no plan of a campaign");
}

TEST_F(RecordedRun, SaysWhichLineIsOfAWrongShape) {
  for (const char* name : {"units.jsonl", "findings.jsonl", "times.jsonl"}) {
    const std::string whole = content_of(file(name));
    const std::string line = std::to_string(lines_of(whole).size() + 1);
    for (const char* object : {R"({"unit":true})", R"({"a":[{}]})", R"({"task":0.5,"found":1})", R"({"unit":1e400})"}) {
      write(name, whole + sealed(object) + "\n");
      EXPECT_TRUE(reason().starts_with(file(name) + ":" + line + ": ")) << reason();
    }
    write(name, whole);
  }
  write("statistics.json", "{\n\"version\": \"te");
  EXPECT_EQ(reason(), file("statistics.json") + ":2: is cut off or no JSON");
}

// Killed at any moment: what is there is reported, and that it is not all.
TEST_F(RecordedRun, ReportsACampaignThatWasKilled) {
  fs::remove(file("statistics.json"));
  write("findings.jsonl", "");
  write("times.jsonl", "");
  const CampaignRecords records = read_recorded_run(run_);
  EXPECT_EQ(records.findings_open, 1);
  EXPECT_EQ(records.differences.size(), 1U);
  EXPECT_NE(page().find("not complete"), std::string::npos);
  EXPECT_NE(page().find("No times were recorded"), std::string::npos);
}

TEST_F(RecordedRun, SaysThatAFindingsFileIsAnother) {
  const std::string name = read_recorded_run(run_).summary.findings.at(0).file;
  write(name, kHeader + "subdivide 1 1 1\n");
  EXPECT_EQ(read_recorded_run(run_).differences, std::vector<std::string>{name + " is not the case of its record"});
  fs::remove(file(name));
  EXPECT_EQ(read_recorded_run(run_).differences, std::vector<std::string>{name + " is missing"});
}

}  // namespace
}  // namespace asts::testing
