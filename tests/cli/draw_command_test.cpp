#include <gtest/gtest.h>

#include <chrono>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

using Names = std::vector<std::string>;

const std::string kFindings = case_path("../../reports/findings/");
const std::string kBad = kFindings + "as-implies-dc.case";

Names files_in(const std::string& folder) {
  Names names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(DrawCommand, DrawsWhereAClaimIsViolated) {
  const TemporaryFolder folder;
  const std::string out = folder.path("new/pictures");
  const Outcome outcome = run({"draw", kBad, "--claim", "as-implies-dc", "--out", out});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "");
  Names expected{"as-implies-dc: violated: no-partial-overlap"};
  const Names names{"as-implies-dc-x-2.svg", "as-implies-dc-y-2.svg", "as-implies-dc-z-2.svg", "as-implies-dc-z-3.svg"};
  for (const std::string& name : names) expected.push_back(out + "/" + name);
  EXPECT_EQ(lines_of(outcome.out), expected);
  EXPECT_EQ(files_in(out), names);
  EXPECT_TRUE(content_of(out + "/as-implies-dc-x-2.svg").ends_with("</svg>\n"));
}

TEST(DrawCommand, DrawsTheMiddleWithoutAStatement) {
  const TemporaryFolder folder;
  const Outcome outcome = run({"draw", "-", "-o", folder.path("")}, kHeader + "refine 0 0 0\n");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(files_in(folder.path("")), (Names{"stdin-x-2.svg", "stdin-y-2.svg", "stdin-z-2.svg"}));
}

TEST(DrawCommand, DrawsTheMiddleWhenAPropertyHolds) {
  const TemporaryFolder folder;
  const Outcome outcome = run({"draw", kBad, "--property", "analysis-suitable", "--out", folder.path("")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(lines_of(outcome.out).at(0), "analysis-suitable: holds");
  EXPECT_EQ(lines_of(outcome.out).size(), 4U);
}

TEST(DrawCommand, DrawsAnExplicitMesh) {
  const TemporaryFolder folder;
  const std::string path = case_path("planar/published-bad-tmesh.case");
  EXPECT_EQ(run({"draw", path, "--property", "dual-compatible", "--out", folder.path("")}).exit_code, 1);
  EXPECT_EQ(files_in(folder.path("")).size(), 5U) << "z = 2 is the same plane for both nodes";
}

// A claim about sequences: what is violated names no place, so the middle of the last mesh is drawn.
TEST(DrawCommand, DrawsForAClaimAboutSequences) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run({"draw", "-", "--claim", "experiment-constant", "--out", folder.path("")}, kHeader + "refine 0 0 0\n");
  EXPECT_LE(outcome.exit_code, 1);
  EXPECT_EQ(files_in(folder.path("")).size(), 3U);
}

TEST(DrawCommand, SpeaksJson) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run({"draw", kBad, "--property", "dual-compatible", "--out", folder.path(""), "--format", "json"});
  const auto records = records_of(outcome.out);
  ASSERT_EQ(records.size(), 5U);
  EXPECT_EQ(records[0].dump(), R"({"property":"dual-compatible","verdict":"violated","kind":"no-partial-overlap"})");
  EXPECT_EQ(keys_of(records[1]), (Names{"file", "axis", "coordinate"}));
  EXPECT_EQ(records[1]["file"], folder.path("as-implies-dc-x-2.svg"));
  EXPECT_EQ(records[1]["axis"], "x");
  EXPECT_EQ(records[1]["coordinate"], "2");
}

TEST(DrawCommand, GivesTheSameBytesTwice) {
  const TemporaryFolder folder;
  for (const char* name : {"one", "two"}) run({"draw", kBad, "--claim", "as-implies-dc", "-o", folder.path(name)});
  for (const std::string& name : files_in(folder.path("one"))) {
    EXPECT_EQ(content_of(folder.path("one/" + name)), content_of(folder.path("two/" + name)));
  }
}

TEST(DrawCommand, NeverOverwritesItsInput) {
  const TemporaryFolder folder;
  const std::string text = kHeader + "refine 0 0 0\n";
  folder.write("a", text);
  std::filesystem::create_symlink(folder.path("a"), folder.path("a-x-2.svg"));
  const Outcome outcome = run({"draw", folder.path("a"), "--out", folder.path("")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(content_of(folder.path("a")), text);
}

TEST(DrawCommand, RefusesAWrongCommandLine) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  for (const Names& arguments :
       {Names{"draw", kBad}, Names{"draw", kBad, "--out", file}, Names{"draw", "none.case", "--out", folder.path("")},
        Names{"draw", kBad, "--claim", "none", "--out", folder.path("")},
        Names{"draw", kBad, "--property", "none", "--out", folder.path("")},
        Names{"draw", kBad, "--property", "admissible", "--claim", "as-implies-dc", "--out", folder.path("")}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << ::testing::PrintToString(arguments);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  }
  EXPECT_EQ(files_in(folder.path("")), (Names{"file"}));
}

// 13,472 elements: three pictures, some seconds at most in any build.
TEST(DrawCommand, IsQuick) {
  const TemporaryFolder folder;
  const Outcome workload = run({"generate", "sphere", "--elements", "10000"});
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(run({"draw", "-", "-o", folder.path("")}, workload.out).exit_code, 0);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_EQ(files_in(folder.path("")), (Names{"stdin-x-8.svg", "stdin-y-8.svg", "stdin-z-8.svg"}));
}

}  // namespace
}  // namespace asts::testing
