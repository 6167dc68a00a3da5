#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

const std::string kRecipe = std::string(ASTS_CASES) + "/../../reports/ci/";

/// Violates dual-compatible after its second step, and minimizing it gives a smaller domain.
const std::string kViolating =
    "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 5 4 5\nsubdivide 1 1 1  4 3 4\nsubdivide 3/2 1 1\n";
const std::string kMinimized =
    "# Counterexample to the property dual-compatible (Definition 6.4): no-partial-overlap.\n"
    "# 2 subdivisions, 2 steps, 4 x 4 x 5 cubes, p = (3,3,3), m = 2, level 2.\n"
    "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 5\nsubdivide 1 1 1\nsubdivide 3/2 1 1\n";

/// Runs the script in a folder, whose cases are in "meshes" and whose results in "run".
class Recipe {
 public:
  Recipe() { std::filesystem::create_directory(folder_.path("meshes")); }

  void add(const std::string& name, const std::string& content) const { folder_.write("meshes/" + name, content); }

  Outcome run(const std::string& environment = {}) const {
    const std::string command =
        "cd '" + folder_.path(".") +
        "' && ASTS='" ASTS_PROGRAM "' ASTS_SECONDS=1 ASTS_JOBS=1 ASTS_CAMPAIGN_OPTIONS='--claim patches-nested' " +
        environment + " bash '" + std::filesystem::canonical(kRecipe).string() + "/run.sh' meshes run >out 2>err";
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), content_of(folder_.path("out")), content_of(folder_.path("err"))};
  }

  std::string kept(const std::string& name) const { return content_of(folder_.path("run/" + name)); }

 private:
  TemporaryFolder folder_;
};

TEST(CiRecipe, PassesWhereEverythingHolds) {
  const Recipe recipe;
  recipe.add("initial.case", kHeader);
  recipe.add("two words.case", kHeader + "refine 0 0 0\n");
  const Outcome outcome = recipe.run();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("==== 2 cases of the project\n"), std::string::npos) << outcome.out;
}

TEST(CiRecipe, FailsWithTheMinimizedCaseInTheLog) {
  const Recipe recipe;
  recipe.add("initial.case", kHeader);
  recipe.add("violating.case", kViolating);
  const Outcome outcome = recipe.run("ASTS_PROPERTIES=dual-compatible");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("==== meshes/violating.case violates dual-compatible; the smallest case that does so in "
                             "the same way:\n" +
                             kMinimized),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(recipe.kept("own/violating-dual-compatible.case"), kMinimized);
  EXPECT_EQ(recipe.kept("own/initial-dual-compatible.case"), "");
}

TEST(CiRecipe, DecidesClaimsToo) {
  const Recipe recipe;
  recipe.add("violating.case", kViolating);
  const Outcome outcome = recipe.run("ASTS_PROPERTIES= ASTS_CLAIMS='patches-nested as-implies-dc'");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  EXPECT_NE(recipe.kept("own/violating-as-implies-dc.case").find("claim as-implies-dc"), std::string::npos);
  EXPECT_EQ(recipe.kept("own/violating-patches-nested.case"), "");
}

TEST(CiRecipe, SaysWhenTheInputIsWrong) {
  const Recipe recipe;
  const Outcome nothing = recipe.run();
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_EQ(nothing.err, "run.sh: meshes: no .case file\n");
  recipe.add("broken.case", "no case\n");
  const Outcome broken = recipe.run();
  EXPECT_EQ(broken.exit_code, 2) << broken.out;
  EXPECT_NE(broken.err.find("meshes/broken.case:1"), std::string::npos) << broken.err;
}

// A second run takes up the campaign of the first; the case that violates the claim that was asked for is in the log.
TEST(CiRecipe, GoesOnWithTheCampaignAndShowsWhatItFound) {
  const Recipe recipe;
  recipe.add("initial.case", kHeader);
  std::size_t blocks = 0;
  for (int round = 0; round < 2; ++round) {
    const Outcome outcome = recipe.run("ASTS_CAMPAIGN_OPTIONS='--claim as-implies-dc'");
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("==== findings/as-implies-dc-no-partial-overlap-"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 5\nsubdivide 1 1 1\n"),
              std::string::npos)
        << outcome.out;
    EXPECT_TRUE(outcome.out.ends_with("==== asts campaign: exit code 1\n")) << outcome.out;
    const std::size_t recorded = lines_of(recipe.kept("campaign/units.jsonl")).size();
    EXPECT_GT(recorded, blocks);
    blocks = recorded;
  }
}

// The workflow runs the script that is tested here, and keeps what it writes even when it fails.
TEST(CiRecipe, IsWhatTheWorkflowRuns) {
  const std::string workflow = content_of(kRecipe + "github-actions.yml");
  EXPECT_NE(workflow.find("        run: asts/reports/ci/run.sh \"$CASES\" asts-run\n"), std::string::npos);
  EXPECT_NE(workflow.find("          path: asts\n"), std::string::npos) << "where the script is";
  const std::size_t kept = workflow.find("uses: actions/upload-artifact@");
  ASSERT_NE(kept, std::string::npos);
  EXPECT_NE(workflow.find("if: always()"), std::string::npos);
  EXPECT_NE(workflow.find("path: asts-run\n", kept), std::string::npos);
  EXPECT_EQ(workflow.find('\t'), std::string::npos) << "YAML has no tabs";
}

}  // namespace
}  // namespace asts::testing
