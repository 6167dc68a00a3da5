#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <set>
#include <thread>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

using Names = std::vector<std::string>;

const std::string kFindings = std::string(ASTS_CASES) + "/../../reports/findings/";

/// Twelve subdivisions, some of them by `refine`, on 7 x 6 x 6 cubes, p = (5,3,3), m = 3.
const std::string kLarge =
    "asts-case 1\ndegree 5 3 3\ngrading 3\ndomain 7 6 6\nsubdivide 3 2 2  5 5 5  0 0 0  6 1 1\n"
    "subdivide 10/3 2 2  5 5 5  0 0 0\nsubdivide 1 1 1  2 3 4  5 0 0  6 5 5  4 4 4\n";

const std::string kLeast =
    "# Counterexample to the claim as-implies-dc (Theorem 6.6, AS within DC): no-partial-overlap.\n"
    "# 2 subdivisions, 2 steps, 4 x 4 x 5 cubes, p = (3,3,3), m = 2, level 2.\n"
    "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 5\nsubdivide 1 1 1\nsubdivide 3/2 1 1\n";

TEST(MinimizeCommand, PrintsTheSmallestCaseAndGivesItBackUnchanged) {
  const TemporaryFolder folder;
  const Outcome first = run({"minimize", kFindings + "as-implies-dc.case", "--claim", "as-implies-dc"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.out, kLeast);
  EXPECT_NE(first.err.find("1-minimal after "), std::string::npos) << first.err;
  const Outcome again = run({"minimize", folder.write("least.case", first.out), "--claim", "as-implies-dc"});
  EXPECT_EQ(again.out, first.out);
  EXPECT_EQ(run({"minimize", "-", "--claim", "as-implies-dc"}, first.out).out, first.out) << "standard input";
}

// The findings are what the minimizer makes, but for those that take minutes and the one that shows a second point.
TEST(MinimizeCommand, LeavesTheFindingsAsTheyAre) {
  for (const char* id : {"as-implies-dc", "as-implies-dual-basis", "dc-implies-as", "case-table", "new-node-split",
                         "perturbed-cover-hanging", "frame-in-index-sets", "planar-equals-classical", "child-distance",
                         "child-distance-bound", "distance-bound"}) {
    const std::string file = kFindings + id + ".case";
    EXPECT_EQ(run({"minimize", file, "--claim", id}).out, content_of(file)) << id;
  }
}

TEST(MinimizeCommand, MinimizesForAPropertyFromALargeCase) {
  const TemporaryFolder folder;
  const std::string file = folder.write("large.case", kLarge);
  const Outcome outcome = run({"minimize", file, "--property", "admissible"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "# Counterexample to the property admissible (Definition 3.2): coarser-in-patch.\n"
            "# 2 subdivisions, 2 steps, 1 x 1 x 2 cubes, p = (3,3,3), m = 2, level 2.\n"
            "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 1 1 2\nsubdivide 0 0 0\nsubdivide 0 0 0\n");
  EXPECT_EQ(content_of(file), kLarge);
}

TEST(MinimizeCommand, WritesToAFileThatIsNotItsInput) {
  const TemporaryFolder folder;
  const std::string file = folder.write("large.case", kLarge);
  const std::string out = folder.path("least.case");
  const Outcome outcome = run({"minimize", file, "--property", "admissible", "--out", out});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(content_of(out).starts_with("# Counterexample to the property admissible")) << content_of(out);
  run({"minimize", file, "--property", "admissible", "--out", out, "--snippet", folder.path("least.cpp")});
  EXPECT_NE(content_of(folder.path("least.cpp")).find("test_case.domain = {1, 1, 2};"), std::string::npos);
  std::filesystem::create_symlink(file, folder.path("link.case"));
  for (const std::string& same : {file, folder.path("link.case"), folder.path("./large.case")}) {
    const Outcome refused = run({"minimize", file, "--property", "admissible", "--out", same});
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_EQ(refused.err, "asts: " + same + ": is the case that is to be minimized\n");
  }
  EXPECT_EQ(content_of(file), kLarge);
}

TEST(MinimizeCommand, JsonSaysHowAndCanBeValidated) {
  const TemporaryFolder folder;
  const std::string file = folder.write("large.case", kLarge);
  const Outcome outcome = run({"minimize", file, "--property", "dual-compatible", "--format", "json", "--prove"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto record = records_of(outcome.out).at(0);
  EXPECT_EQ(keys_of(record), (Names{"case", "property", "kind", "size", "guarantee", "evaluations", "proof", "last_run",
                                    "others", "step", "elements", "properties", "witness_format", "mesh"}));
  EXPECT_EQ(record["size"]["subdivisions"], 2);
  EXPECT_EQ(record["size"]["domain"], (std::vector<int>{4, 4, 5}));
  EXPECT_EQ(record["elements"], 82);
  EXPECT_EQ(record["guarantee"], "exhaustive");
  EXPECT_EQ(record["proof"]["complete"], true);
  EXPECT_EQ(record["proof"]["max_subdivisions"], 2);
  EXPECT_EQ(record["proof"]["max_volume"], 160);
  EXPECT_GT(record["proof"]["meshes"], 1'000'000);
  EXPECT_FALSE(record["last_run"].empty());
  for (const auto& pass : record["last_run"]) EXPECT_EQ(pass["accepted"], false);
  EXPECT_EQ(run({"validate", folder.write("record.json", outcome.out)}).exit_code, 0);
}

TEST(MinimizeCommand, EndsWithinABudget) {
  const TemporaryFolder folder;
  const std::string file = folder.write("large.case", kLarge);
  const Outcome outcome = run({"minimize", file, "--property", "dual-compatible", "--budget", "12"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("budget after 12 evaluations"), std::string::npos) << outcome.err;
  const std::string part = folder.write("part.case", outcome.out);
  EXPECT_EQ(run({"check", "--final", "--property", "dual-compatible", part}).exit_code, 1) << outcome.out;
}

TEST(MinimizeCommand, AddsToACollection) {
  const TemporaryFolder folder;
  const std::string file = folder.write("boxes.case",
                                        "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 3 1 1\n"
                                        "element 0 0 0  1/3 1 1\nelement 1/3 0 0  1 1 1\nelement 1 0 0  2 1 1\n"
                                        "element 2 0 0  5/2 1 1\nelement 5/2 0 0  3 1/2 1\n"
                                        "element 5/2 1/2 0  3 1 1\n");
  const std::string collection = folder.path("collection");
  std::filesystem::create_directory(collection);
  const Outcome outcome = run({"minimize", file, "--property", "admissible", "--collect", collection});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("coarser-in-patch"), std::string::npos) << outcome.out;
  std::set<std::string> kinds;
  for (const auto& entry : std::filesystem::directory_iterator(collection)) {
    const std::string name = entry.path().filename().string();
    kinds.insert(name.substr(0, name.size() - std::string("-0123456789abcdef.case").size()));
    if (name.starts_with("admissible-outside-class")) {
      EXPECT_EQ(content_of(entry.path().string()), outcome.out);
    }
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"admissible-coarser-in-patch", "admissible-outside-class"}));
  EXPECT_EQ(run({"replay", collection}).exit_code, 0);
}

TEST(MinimizeCommand, LeavesACaseOfTheCollectionAsItIs) {
  const TemporaryFolder folder;
  const std::string commented = "# my own words\n" + kLeast.substr(kLeast.find("asts-case"));
  const std::string file = folder.write("as-implies-dc-no-partial-overlap-f06d209a3685d197.case", commented);
  const Outcome outcome = run({"minimize", file, "--claim", "as-implies-dc", "--collect", folder.path("")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(content_of(file), commented);
  EXPECT_NE(outcome.err.find("left as it is"), std::string::npos) << outcome.err;
}

TEST(MinimizeCommand, DrawsTheSlicesOfTheSmallestMesh) {
  const TemporaryFolder folder;
  const std::string file = folder.write("large.case", kLarge);
  EXPECT_EQ(run({"minimize", file, "--property", "dual-compatible", "--draw", folder.path("")}).exit_code, 0);
  std::set<std::string> pictures;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path(""))) {
    if (entry.path().extension() == ".svg") pictures.insert(entry.path().filename().string());
  }
  EXPECT_EQ(pictures, (std::set<std::string>{
                          "dual-compatible-no-partial-overlap-x-2.svg", "dual-compatible-no-partial-overlap-y-2.svg",
                          "dual-compatible-no-partial-overlap-z-2.svg", "dual-compatible-no-partial-overlap-z-3.svg"}));
}

// A case that takes some twenty seconds.
TEST(MinimizeCommand, PrintsTheBestSoFarWhenInterrupted) {
  const std::string file = kFindings + "experiment-constant.case";
  const std::string before = content_of(file);
  Process process({"minimize", file, "--claim", "experiment-constant"});
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  kill(process.id(), SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_NE(outcome.err.find("interrupted after "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("asts-case 1\ndegree 3 3 3\ngrading 3\ndomain 5 5 5\nrefine 0 0 0\n"), std::string::npos);
  EXPECT_EQ(content_of(file), before);
}

TEST(MinimizeCommand, RefusesWhatItCannotMinimize) {
  const TemporaryFolder folder;
  const std::string file = folder.write("uniform.case", "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n");
  const auto refusal = [&](Names options) {
    options.insert(options.begin(), {"minimize", file});
    const Outcome outcome = run(options);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  EXPECT_EQ(refusal({"--property", "admissible"}),
            "asts: " + file + ": the case does not violate what it is to be minimized for\n");
  EXPECT_EQ(refusal({}), "asts: one of --claim and --property is needed\n");
  EXPECT_EQ(refusal({"--claim", "as-implies-dc", "--property", "admissible"}),
            "asts: one of --claim and --property is needed\n");
  EXPECT_EQ(refusal({"--claim", "figure-slices"}), "asts: 'figure-slices' is about no case\n");
  EXPECT_NE(refusal({"--claim", "none"}).find("none"), std::string::npos);
  EXPECT_NE(refusal({"--property", "admissible", "--budget", "0"}).find("--budget"), std::string::npos);
  EXPECT_NE(refusal({"--property", "admissible", "--collect", folder.path("none")}).find("is no folder"),
            std::string::npos);
}

}  // namespace
}  // namespace asts::testing
