#include "fuzz/campaign/run_directory.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <map>
#include <thread>

#include "fuzz/campaign/campaign.hpp"
#include "lib/exact/errors.hpp"
#include "lib/gen/draw.hpp"
#include "lib/mesh/case_file.hpp"
#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

namespace fs = std::filesystem;

/// Cheap to try; one is refuted and found often.
CampaignPlan small_plan() {
  CampaignPlan plan;
  for (const char* id : {"as-implies-dc", "child-distance"}) plan.claims.push_back(find_claim(id));
  plan.version = "test";
  plan.seed = 3;
  return plan;
}

constexpr std::int64_t kCases = 200;

CampaignResult run_in(const std::string& folder, const CampaignPlan& plan, std::int64_t cases = kCases, int jobs = 1) {
  RunDirectory directory(folder, true);
  CampaignRun how;
  how.jobs = jobs;
  how.cases = cases;
  return run_campaign(plan, how, &directory);
}

/// The files that depend on plan and cases alone, by name.
std::map<std::string, std::string> files_of(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (entry.is_regular_file() && name != "times.jsonl" && name != "lock") {
      files[name] = content_of(entry.path().string());
    }
  }
  return files;
}

/// The names of the files that differ.
std::vector<std::string> differences(const std::map<std::string, std::string>& one,
                                     const std::map<std::string, std::string>& other) {
  std::vector<std::string> names;
  for (const auto& [name, content] : one) {
    if (!other.contains(name) || other.at(name) != content) names.push_back(name);
  }
  for (const auto& [name, content] : other) {
    if (!one.contains(name)) names.push_back(name);
  }
  return names;
}

using Names = std::vector<std::string>;

const Names kNone;

class RunDirectoryTest : public ::testing::Test {
 protected:
  void SetUp() override {
    run_in(folder_.path("whole"), plan_);
    whole_ = files_of(folder_.path("whole"));
  }

  /// A folder as the whole one, but for one file.
  std::string folder_with(const std::string& name, const std::string& content) const {
    const std::string folder = folder_.path("cut");
    fs::copy(folder_.path("whole"), folder, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    std::ofstream(folder + "/" + name, std::ios::binary) << content;
    return folder;
  }

  TemporaryFolder folder_;
  CampaignPlan plan_ = small_plan();
  std::map<std::string, std::string> whole_;
};

TEST_F(RunDirectoryTest, HoldsWhatWasFound) {
  const auto recorded = read_campaign(folder_.path("whole"));
  ASSERT_TRUE(recorded);
  EXPECT_EQ(recorded->plan, plan_);
  EXPECT_EQ(recorded->summary.cases, kCases);
  std::size_t cases = 0;
  for (const CampaignFinding& finding : recorded->summary.findings) {
    if (!finding.content) continue;  // child-distance is violated without one, too
    ++cases;
    EXPECT_EQ(finding.valid, true) << finding.validation;
    EXPECT_EQ(content_of(folder_.path("whole/" + finding.file)), write_case(*finding.content));
  }
  EXPECT_GE(cases, 2U);
  EXPECT_EQ(whole_.size(), cases + 2);
}

Names texts_of(const CampaignSummary& summary) {
  Names texts;
  for (const CampaignFinding& finding : summary.findings)
    texts.push_back(finding.file + finding.says + finding.validation);
  return texts;
}

Names first(const Names& names, std::size_t count) {
  return Names(names.begin(), names.begin() + static_cast<long>(std::min(count, names.size())));
}

bool near_line_end(const std::string& text, std::size_t place) {
  const std::size_t end = text.find('\n', place < 2 ? 0 : place - 2);
  return end != std::string::npos && end < place + 64;
}

// Wherever a file is cut: what is read is what was complete, and never another record.
TEST_F(RunDirectoryTest, IsReadWhereverItIsCut) {
  const Names all = texts_of(read_campaign(folder_.path("whole"))->summary);
  for (const char* name : {"units.jsonl", "findings.jsonl"}) {
    const std::string text = whole_.at(name);
    const std::string folder = folder_with(name, text);
    for (std::size_t bytes = 0; bytes <= text.size(); bytes += near_line_end(text, bytes) ? 1 : 61) {
      folder_.write("cut/" + std::string(name), text.substr(0, bytes));
      const auto recorded = read_campaign(folder);
      const auto lines = std::count(text.begin(), text.begin() + static_cast<long>(bytes), '\n');
      if (std::string(name) == "findings.jsonl") {
        ASSERT_TRUE(recorded);
        EXPECT_EQ(recorded->summary.cases, kCases);
        EXPECT_EQ(texts_of(recorded->summary), first(all, recorded->summary.findings.size())) << bytes;
        EXPECT_LE(recorded->summary.findings.size(), static_cast<std::size_t>(lines));
        continue;
      }
      ASSERT_EQ(recorded.has_value(), lines > 0) << bytes;
      if (!recorded) continue;
      const std::int64_t blocks = std::max<std::int64_t>(lines - 2, 0);  // behind the plan and what needs no case
      EXPECT_EQ(recorded->summary.cases, std::min(kCases, blocks * kBlockCases)) << bytes;
    }
  }
}

TEST_F(RunDirectoryTest, GoesOnToTheSameBytesWhereverItIsCut) {
  Draw draw(11);
  for (int i = 0; i < 24; ++i) {
    const char* name = draw.one_in(2) ? "units.jsonl" : "findings.jsonl";
    const std::string text = whole_.at(name);
    const std::size_t bytes = draw.index(text.size());
    const std::string folder = folder_with(name, text.substr(0, bytes));
    run_in(folder, plan_);
    EXPECT_EQ(differences(files_of(folder), whole_), kNone) << name << " cut to " << bytes;
  }
}

TEST_F(RunDirectoryTest, IsTheSameForAnyNumberOfJobs) {
  run_in(folder_.path("three"), plan_, kCases, 3);
  EXPECT_EQ(differences(files_of(folder_.path("three")), whole_), kNone);
}

// The number of cases that was asked for first stands in the plan's line, and only there.
TEST_F(RunDirectoryTest, GoesOnToMoreCases) {
  const auto without_plan = [](std::map<std::string, std::string> files) {
    std::string& units = files.at("units.jsonl");
    units.erase(0, units.find('\n'));
    return files;
  };
  const std::string folder = folder_.path("more");
  run_in(folder, plan_, 70);
  EXPECT_NE(differences(without_plan(files_of(folder)), without_plan(whole_)), kNone);
  run_in(folder, plan_);
  EXPECT_EQ(differences(without_plan(files_of(folder)), without_plan(whole_)), kNone);
  run_in(folder, plan_, 64);  // they are there already
  EXPECT_EQ(differences(without_plan(files_of(folder)), without_plan(whole_)), kNone);
}

// As a power cut would, but for what the disk loses: killed at a random moment, again and again.
TEST_F(RunDirectoryTest, GoesOnToTheSameBytesWhereverItIsKilled) {
  Draw draw(29);
  const std::string folder = folder_.path("killed");
  for (int i = 0; i < 12; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      run_in(folder, plan_, kCases, 2);
      _exit(0);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(draw.between(1, 60)));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
  run_in(folder, plan_);
  EXPECT_EQ(differences(files_of(folder), whole_), kNone);
}

TEST_F(RunDirectoryTest, RefusesAnotherCampaignsRecords) {
  EXPECT_THROW(RunDirectory(folder_.path("whole"), false), InputError);
  const std::string text = whole_.at("units.jsonl");
  const std::size_t first = text.find('\n') + 1;
  const std::size_t second = text.find('\n', first) + 1;
  const std::string folder = folder_with("units.jsonl", text.substr(0, first) + text.substr(second));
  const auto refusal = [](const std::string& refused) -> std::string {
    try {
      read_campaign(refused);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(refusal(folder), folder + "/units.jsonl:2: a unit is missing");
  EXPECT_THROW(run_in(folder, plan_), InputError);
  std::string damaged = text;
  damaged[first + 5] ^= 1;
  EXPECT_EQ(refusal(folder_with("units.jsonl", damaged)), folder + "/units.jsonl:2: the record is damaged");
  EXPECT_EQ(refusal(folder_with("units.jsonl", sealed("{\"a\":1}") + "\n")).find(folder + "/units.jsonl:1: no plan"),
            0U);
  EXPECT_THROW(read_campaign(folder_.path("none")), InputError);
  const std::string other = folder_with("units.jsonl", "{}\n");  // no campaign's: it is not written over
  EXPECT_THROW(RunDirectory(other, true), InputError);
  EXPECT_EQ(content_of(other + "/units.jsonl"), "{}\n");
}

}  // namespace
}  // namespace asts::testing
