#include <gtest/gtest.h>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

const std::string kReports = std::string(ASTS_CASES) + "/../../reports/";

const std::string kNotCompatible =
    "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 5\nsubdivide 1 1 1\nsubdivide 3/2 1 1\n";

TEST(ReplayCommand, ReplaysTheFindings) {
  const Outcome outcome = run({"replay", kReports + "findings"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_NE(outcome.out.find("as-implies-dc.case: as-implies-dc: violated (no-partial-overlap)\n"), std::string::npos);
}

TEST(ReplayCommand, ReplaysTheCollection) {
  const Outcome outcome = run({"replay", kReports + "collection"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_TRUE(lines_of(outcome.out).back().ends_with("cases are as recorded")) << outcome.out;
  EXPECT_GE(lines_of(outcome.out).size(), 18U);
}

TEST(ReplayCommand, SaysWhatIsNotAsRecorded) {
  const TemporaryFolder folder;
  folder.write("as-implies-dc.case", "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n");
  folder.write("as-implies-dc-repaired-regression.case", kNotCompatible);
  folder.write("dual-compatible-other-kind-0123456789abcde.case", kNotCompatible);
  const Outcome outcome = run({"replay", folder.path("")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out,
            "as-implies-dc-repaired-regression.case: as-implies-dc-repaired: not-applicable\n"
            "as-implies-dc.case: as-implies-dc: holds, but was to be violated\n"
            "dual-compatible-other-kind-0123456789abcde.case: dual-compatible: violated (no-partial-overlap)\n"
            "2 of 3 cases are as recorded\n");
  const auto records = records_of(run({"replay", folder.path(""), "--format", "json"}).out);
  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(keys_of(records[2]),
            (std::vector<std::string>{"file", "property", "expected", "verdict", "kind", "as_recorded"}));
  EXPECT_EQ(records[1]["as_recorded"], false);
}

TEST(ReplayCommand, HoldsAFullNameAgainstItsKindAndCase) {
  const TemporaryFolder folder;
  const Outcome collected = run({"minimize", folder.write("start", kNotCompatible), "--claim", "as-implies-dc"});
  const std::string hash = "f06d209a3685d197";
  const std::string file = folder.write("as-implies-dc-no-partial-overlap-" + hash + ".case", collected.out);
  EXPECT_EQ(run({"replay", folder.path("")}).err, "");
  EXPECT_EQ(run({"replay", folder.path("")}).exit_code, 0);
  folder.write("as-implies-dc-other-kind-" + hash + ".case", collected.out);
  EXPECT_EQ(run({"replay", folder.path("")}).exit_code, 1);
  folder.write("as-implies-dc-no-partial-overlap-" + hash + ".case", collected.out + "subdivide 1 1 1\n");
  const Outcome changed = run({"replay", folder.path("")});
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_EQ(changed.out, "");
  EXPECT_NE(changed.err.find("is not the case that its name was given for"), std::string::npos) << changed.err;
}

TEST(ReplayCommand, RefusesEmptyAndUnreadableCollections) {
  const TemporaryFolder folder;
  const std::string path = folder.path("");
  EXPECT_EQ(run({"replay", path}).err, "asts: " + path + ": has no case\n");
  EXPECT_EQ(run({"replay", path}).exit_code, 2);
  EXPECT_EQ(run({"replay", path + "none"}).err, "asts: " + path + "none: is no folder that can be read\n");
  folder.write("as-implies-dc.case", kNotCompatible);
  folder.write("no-claim.case", kNotCompatible);
  EXPECT_EQ(run({"replay", path}).err,
            "asts: " + path + "no-claim.case: its name begins with the id of no claim and no property\n");
  std::filesystem::remove(folder.path("no-claim.case"));
  folder.write("as-implies-dc-bad.case", "asts-case 1\ndegree 3\n");
  const Outcome malformed = run({"replay", path});
  EXPECT_EQ(malformed.exit_code, 2);
  EXPECT_EQ(malformed.out, "");
  EXPECT_NE(malformed.err.find("as-implies-dc-bad.case:2:"), std::string::npos) << malformed.err;
}

}  // namespace
}  // namespace asts::testing
