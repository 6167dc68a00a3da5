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

  void add(const std::string& name, const std::string& content) const { write("meshes/" + name, content); }

  void write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories(std::filesystem::path(folder_.path(name)).parent_path());
    folder_.write(name, content);
  }

  /// Runs it with a program whose campaign has this exit code and prints nothing: what it wrote is there already.
  Outcome run_with_campaign_of(int exit_code) const {
    add("initial.case", kHeader);
    write("program", "#!/bin/sh\n[ \"$1\" != campaign ] || exit " + std::to_string(exit_code) + "\n");
    std::filesystem::permissions(folder_.path("program"), std::filesystem::perms::owner_all);
    return run("ASTS=./program");
  }

  Outcome run(const std::string& environment = {}) const { return run_on("meshes", environment); }

  Outcome run_on(const std::string& cases, const std::string& environment = {}) const {
    const std::string command = "cd '" + folder_.path(".") +
                                "' && ASTS='" ASTS_PROGRAM
                                "' ASTS_SECONDS=1 ASTS_JOBS=1 ASTS_CAMPAIGN_OPTIONS='--claim patches-nested' " +
                                environment + " bash '" + std::filesystem::canonical(kRecipe).string() + "/run.sh' " +
                                cases + " run >out 2>err";
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), content_of(folder_.path("out")), content_of(folder_.path("err"))};
  }

  /// The names of the minimized cases, and of all else in their folder, in alphabetical order.
  std::vector<std::string> own() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path("run/own"))) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
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
  EXPECT_EQ(recipe.own(), std::vector<std::string>{"violating-dual-compatible.case"});
}

TEST(CiRecipe, KeepsTheSmallestThatIsFoundWithinTheBudget) {
  const Recipe recipe;
  recipe.add("violating.case", kViolating);
  const Outcome outcome = recipe.run("ASTS_PROPERTIES=dual-compatible ASTS_BUDGET=10");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  EXPECT_EQ(recipe.kept("own/violating-dual-compatible.case"), kMinimized);
  EXPECT_NE(outcome.out.find(kMinimized), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nbudget after 10 evaluations\n"), std::string::npos) << outcome.out;
}

// The third step mends what the second breaks.
TEST(CiRecipe, MinimizesTheFirstMeshThatViolates) {
  const Recipe recipe;
  recipe.add("mended.case", kViolating + "subdivide 1 1 2\n");
  const Outcome outcome = recipe.run("ASTS_PROPERTIES=dual-compatible");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("meshes/mended.case: step 3: 104 elements (7 new), level 2, 4 active nodes: "
                             "dual-compatible holds\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(recipe.kept("own/mended-dual-compatible.case"), kMinimized) << outcome.out;
}

TEST(CiRecipe, KeepsAnotherCaseForEachFile) {
  const Recipe recipe;
  for (const char* name : {"a/x.case", "a%2Fx.case", "b/c/x.case", "x.case"}) recipe.add(name, kViolating);
  EXPECT_EQ(recipe.run("ASTS_PROPERTIES=dual-compatible").exit_code, 1);
  EXPECT_EQ(recipe.own(), (std::vector<std::string>{"a%252Fx-dual-compatible.case", "a%2Fx-dual-compatible.case",
                                                    "b%2Fc%2Fx-dual-compatible.case", "x-dual-compatible.case"}));
}

TEST(CiRecipe, KeepsNothingOfAnEarlierRun) {
  const Recipe recipe;
  recipe.add("x.case", kViolating);
  EXPECT_EQ(recipe.run("ASTS_PROPERTIES=dual-compatible").exit_code, 1);
  EXPECT_EQ(recipe.own().size(), 1u);
  recipe.add("x.case", kHeader);
  EXPECT_EQ(recipe.run("ASTS_PROPERTIES=dual-compatible").exit_code, 0);
  EXPECT_EQ(recipe.own(), std::vector<std::string>{});
}

TEST(CiRecipe, DecidesClaimsToo) {
  const Recipe recipe;
  recipe.add("violating.case", kViolating);
  const Outcome outcome = recipe.run("ASTS_PROPERTIES= ASTS_CLAIMS='patches-nested as-implies-dc'");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
  EXPECT_NE(recipe.kept("own/violating-as-implies-dc.case").find("claim as-implies-dc"), std::string::npos);
  EXPECT_EQ(recipe.own(), std::vector<std::string>{"violating-as-implies-dc.case"});
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
  recipe.write("run/own/x.case", kHeader);
  EXPECT_EQ(recipe.run_on("run/own").exit_code, 2) << "what is kept there is replaced";
  EXPECT_EQ(recipe.kept("own/x.case"), kHeader);
}

// A second run takes up the campaign of the first; the case that violates the claim that was asked for is in the log.
TEST(CiRecipe, GoesOnWithTheCampaignAndShowsWhatItFound) {
  const Recipe recipe;
  recipe.add("initial.case", kHeader);
  std::size_t blocks = 0;
  for (int round = 0; round < 2; ++round) {
    const Outcome outcome = recipe.run("ASTS_CAMPAIGN_OPTIONS='--claim as-implies-dc'");
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("as-implies-dc: no-partial-overlap: findings/as-implies-dc-no-partial-overlap-"),
              std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 5\nsubdivide 1 1 1\n"),
              std::string::npos)
        << outcome.out;
    EXPECT_TRUE(outcome.out.ends_with("==== asts campaign: exit code 1\n")) << outcome.out;
    const std::size_t recorded = lines_of(recipe.kept("campaign/units.jsonl")).size();
    EXPECT_GT(recorded, blocks);
    blocks = recorded;
  }
}

TEST(CiRecipe, ShowsTheUnexpectedWhereverItsCaseIs) {
  const Recipe recipe;
  recipe.write("run/campaign/statistics.txt",
               "findings: 4, 3 of them unexpected\n\n"
               "new-node-split: split: findings/expected.case\n    expected\n\n"
               "UNEXPECTED while no claim was tried: crash\n    signal: 11.case\n\n"
               "UNEXPECTED patches-nested: timeout: deaths/late.case\n    20 s\n\n"
               "UNEXPECTED patches-nested: outside: findings/found.case\n    found\n");
  recipe.write("run/campaign/findings/expected.case", "expected\n");
  recipe.write("run/campaign/findings/found.case", "found\n");
  recipe.write("run/campaign/deaths/late.case", "late\n");
  const Outcome outcome = recipe.run_with_campaign_of(1);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      outcome.out.ends_with("==== UNEXPECTED while no claim was tried: crash\n"
                            "==== UNEXPECTED patches-nested: timeout: deaths/late.case\nlate\n"
                            "==== UNEXPECTED patches-nested: outside: findings/found.case\nfound\n"
                            "==== asts campaign: exit code 1\n"))
      << outcome.out;
  EXPECT_EQ(outcome.out.find("expected.case"), std::string::npos) << outcome.out;
}

TEST(CiRecipe, ShowsNoOtherFindingsWhereTheUnexpectedOneHasNoCase) {
  const Recipe recipe;
  recipe.write("run/campaign/statistics.txt",
               "new-node-split: split: findings/expected.case\n\nUNEXPECTED while no claim was tried: crash\n");
  recipe.write("run/campaign/findings/expected.case", "expected\n");
  const Outcome outcome = recipe.run_with_campaign_of(1);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out,
            "==== 1 cases of the project\n==== UNEXPECTED while no claim was tried: crash\n"
            "==== asts campaign: exit code 1\n");
}

TEST(CiRecipe, FailsWhereTheCampaignIsKilled) {
  const Recipe recipe;
  const Outcome outcome = recipe.run_with_campaign_of(137);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_TRUE(outcome.out.ends_with("==== asts campaign: exit code 137\n")) << outcome.out;
}

// The workflow runs the script that is tested here, and keeps what it writes even when it fails: as an artifact, and
// for the next run, which "actions/cache" alone keeps only after success.
TEST(CiRecipe, IsWhatTheWorkflowRuns) {
  const std::string workflow = content_of(kRecipe + "github-actions.yml");
  EXPECT_NE(workflow.find("        run: asts/reports/ci/run.sh \"$CASES\" asts-run\n"), std::string::npos);
  EXPECT_NE(workflow.find("          path: asts\n"), std::string::npos) << "where the script is";
  const std::size_t taken_up = workflow.find("        uses: actions/cache/restore@v4\n");
  const std::size_t run = workflow.find("run.sh");
  EXPECT_LT(taken_up, run);
  EXPECT_NE(workflow.find("        id: last\n"), std::string::npos);
  const std::string always = "        if: always()\n        uses: ";
  const std::string save =
      "actions/cache/save@v4\n        with:\n          path: asts-run\n"
      "          key: ${{ steps.last.outputs.cache-primary-key }}\n";
  for (const std::string& action : {save, std::string("actions/upload-artifact@v4\n")}) {
    const std::size_t kept = workflow.find(always + action);
    ASSERT_NE(kept, std::string::npos) << action;
    EXPECT_GT(kept, run);
    EXPECT_NE(workflow.find("path: asts-run\n", kept), std::string::npos);
  }
  EXPECT_EQ(workflow.find("actions/cache@"), std::string::npos);
  EXPECT_EQ(workflow.find('\t'), std::string::npos) << "YAML has no tabs";
}

}  // namespace
}  // namespace asts::testing
