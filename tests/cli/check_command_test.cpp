#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

using Names = std::vector<std::string>;

const Names kProperties{"admissible", "nested-patches", "analysis-suitable", "dual-compatible", "dual-basis"};
const std::string kExample = case_path("paper/example-2.10-m4.case");
const std::string kBadMesh = case_path("planar/published-bad-tmesh.case");

TEST(CheckCommand, WritesOneRecordAMeshWithTheContractsKeysInTheirOrder) {
  const Outcome outcome = run({"check", "--format", "json", kExample});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const auto records = records_of(outcome.out);
  ASSERT_EQ(records.size(), 7U);
  for (std::size_t step = 0; step < records.size(); ++step) {
    EXPECT_EQ(keys_of(records[step]),
              (Names{"case", "step", "elements", "new_elements", "max_level", "active_nodes", "properties"}));
    EXPECT_EQ(records[step]["case"], kExample);
    EXPECT_EQ(records[step]["step"], step);
    EXPECT_EQ(records[step]["max_level"], step);
    EXPECT_EQ(keys_of(records[step]["properties"]), kProperties);
    for (const auto& [id, entry] : records[step]["properties"].items()) {
      EXPECT_EQ(entry.dump(), R"({"verdict":"holds"})") << id;
    }
  }
  EXPECT_EQ(records[0]["new_elements"], 0);
  EXPECT_EQ(records[6]["new_elements"], 3175);
}

TEST(CheckCommand, HoldsOnEveryMeshOfThePapersExamples) {
  Names arguments{"check", "--format", "json"};
  for (const std::string& path : all_case_paths()) {
    if (path.find("/paper/") != std::string::npos) arguments.push_back(path);
  }
  ASSERT_GE(arguments.size(), 8U);
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.find("violated"), std::string::npos);
}

TEST(CheckCommand, FinalGivesTheLastRecordOnly) {
  const Names all = lines_of(run({"check", "--format", "json", kExample}).out);
  const Names last = lines_of(run({"check", "--format", "json", "--final", kExample}).out);
  EXPECT_EQ(last, Names{all.back()});
}

TEST(CheckCommand, TakesPropertiesInAnyOrderAndPrintsThemInTheirOwn) {
  const Outcome outcome = run({"check", "--final", "--format", "json", "--property", "dual-basis", "--property",
                               "admissible", "--property", "dual-basis", kExample});
  EXPECT_EQ(outcome.exit_code, 0);
  const auto records = records_of(outcome.out);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(keys_of(records[0]["properties"]), (Names{"admissible", "dual-basis"}));
}

TEST(CheckCommand, KeepsTheOrderOfSeveralCases) {
  const Outcome outcome = run({"check", "--final", "--format", "json", kBadMesh, kExample, kBadMesh});
  EXPECT_EQ(outcome.exit_code, 1) << "one violated property is enough";
  const auto records = records_of(outcome.out);
  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(records[0]["case"], kBadMesh);
  EXPECT_EQ(records[1]["case"], kExample);
  EXPECT_EQ(records[2], records[0]);
}

TEST(CheckCommand, ReadsStandardInput) {
  const Outcome outcome = run({"check", "--format", "json", "-"}, content_of(kExample));
  EXPECT_EQ(outcome.exit_code, 0);
  auto records = records_of(outcome.out);
  const auto expected = records_of(run({"check", "--format", "json", kExample}).out);
  ASSERT_EQ(records.size(), expected.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i]["case"], "-");
    records[i]["case"] = kExample;
    EXPECT_EQ(records[i], expected[i]);
  }
}

// The case's own words: the crossing segments make three properties fail; nested patches hold in the class that is
// left.
TEST(CheckCommand, GivesTheWitnessesAndTheMeshOfAViolatedRecord) {
  const Outcome outcome = run({"check", "--format", "json", kBadMesh});
  EXPECT_EQ(outcome.exit_code, 1);
  const auto records = records_of(outcome.out);
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(keys_of(records[0]).back(), "mesh");
  for (const std::string& id : kProperties) {
    const auto& entry = records[0]["properties"][id];
    EXPECT_EQ(entry["verdict"], id == "nested-patches" ? "holds" : "violated") << id;
    EXPECT_EQ(entry.contains("witness"), id != "nested-patches") << id;
  }
  const TemporaryFolder folder;
  const std::string again = folder.write("mesh.case", records[0]["mesh"].get<std::string>());
  EXPECT_EQ(records_of(run({"check", "--format", "json", again}).out)[0]["properties"], records[0]["properties"]);
}

// 2 x 2 x 2 cubes and degree 3: the active region is empty, so that nothing is said about splines.
TEST(CheckCommand, DoesNotCallWhatDoesNotApplyHolding) {
  const Outcome outcome =
      run({"check", "--format", "json", "-"}, "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 2 2 2\n");
  EXPECT_EQ(outcome.exit_code, 0);
  const auto properties = records_of(outcome.out)[0]["properties"];
  for (const char* id : {"analysis-suitable", "dual-compatible", "dual-basis"}) {
    EXPECT_EQ(properties[id]["verdict"], "not-applicable") << id;
  }
  EXPECT_EQ(properties["admissible"]["verdict"], "holds");
}

TEST(CheckCommand, SaysUndecidedWhenTheBudgetEnds) {
  const Outcome outcome = run({"check", "--final", "--budget", "1", "--property", "dual-basis", "--format", "json",
                               case_path("paper/theorem-5.3-proof.case")});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(records_of(outcome.out)[0]["properties"]["dual-basis"]["verdict"], "undecided");
}

TEST(CheckCommand, IsTheSameByteByByteInEveryRunAndFolder) {
  const TemporaryFolder folder;
  std::filesystem::copy(kBadMesh, folder.path("a.case"));
  for (const char* format : {"text", "json"}) {
    const Outcome first = run({"check", "--format", format, kBadMesh, kExample});
    const Outcome second = run({"check", "--format", format, kBadMesh, kExample}, {}, "/");
    EXPECT_EQ(first.out, second.out);
    const Outcome here = run({"check", "--format", format, "a.case"}, {}, folder.path(""));
    EXPECT_EQ(here.exit_code, 1);
    EXPECT_EQ(here.out.find(folder.path("")), std::string::npos) << "only the name that was given is printed";
  }
}

// The bytes do not depend on the number of threads: meshes that hold and one that is violated.
TEST(CheckCommand, PrintsTheSameBytesForAnyNumberOfJobs) {
  const TemporaryFolder folder;
  const std::string sphere =
      folder.write("sphere.case", run({"generate", "sphere", "--domain", "8,8,8", "--elements", "10000"}).out);
  const std::string violated = case_path("../../reports/findings/as-implies-dc.case");
  const Outcome expected = run({"check", "--format", "json", sphere, violated});
  EXPECT_EQ(expected.exit_code, 1);
  for (const char* jobs : {"1", "2", "3"}) {
    const Outcome outcome = run({"check", "--format", "json", "--jobs", jobs, sphere, violated});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.out, expected.out);
  }
  EXPECT_EQ(run({"check", sphere, "--jobs", "0"}).exit_code, 2);
  EXPECT_EQ(run({"check", sphere, "--jobs", "257"}).exit_code, 2);
}

// Checks every mesh of 100000 steps, which takes minutes, and interrupts as soon as there is something on stdout.
TEST(CheckCommand, WritesWholeLinesOnlyWhenInterrupted) {
  const TemporaryFolder folder;
  std::string text = kHeader;
  for (int i = 0; i < 100'000; ++i) text += "refine\n";
  for (const int signal : {SIGINT, SIGTERM}) {
    Process process({"check", "--format", "json", folder.write("long.case", text)});
    while (process.out_so_far().empty() && waitpid(process.id(), nullptr, WNOHANG) == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(process.id(), signal);
    const Outcome outcome = process.wait();
    EXPECT_EQ(outcome.exit_code, 130);
    ASSERT_FALSE(outcome.out.empty());
    EXPECT_EQ(outcome.out.back(), '\n');
    const auto records = records_of(outcome.out);  // throws when a line is no object
    EXPECT_LT(records.size(), 100'001U);
    EXPECT_EQ(records.back()["step"], records.size() - 1);
  }
}

}  // namespace
}  // namespace asts::testing
