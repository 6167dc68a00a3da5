#include <gtest/gtest.h>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

// The whole text on the published mesh that is not analysis-suitable, against tests/cli/published-bad-tmesh.txt, which
// was read line by line against the case's own hand calculation. When a witness or the wording changes, read it again:
//     cd PROJECT && asts check tests/cases/planar/published-bad-tmesh.case > tests/cli/published-bad-tmesh.txt
TEST(ReportText, IsTheOneThatAPersonReadThrough) {
  const std::string root = std::string(ASTS_CASES) + "/../..";
  const Outcome outcome = run({"check", "tests/cases/planar/published-bad-tmesh.case"}, {}, root);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(lines_of(outcome.out), lines_of(content_of(root + "/tests/cli/published-bad-tmesh.txt")));
}

TEST(ReportText, SaysOneLineAMeshWhenAllHolds) {
  const Outcome outcome = run({"check", "--final", "-"}, kHeader + "refine 0 0 0\n");
  EXPECT_EQ(lines_of(outcome.out)[0], "-: step 1: 65 elements (2 new), level 1, 1 active nodes: all hold");
  const Outcome one = run({"check", "--final", "--property", "dual-basis", "-"}, kHeader);
  EXPECT_EQ(lines_of(one.out)[0], "-: step 0: 64 elements (0 new), level 0, 1 active nodes: dual-basis holds");
}

}  // namespace
}  // namespace asts::testing
