#include <gtest/gtest.h>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

using Names = std::vector<std::string>;
using namespace std::string_literals;

/// Exit code 2, nothing on stdout, one line on stderr that begins with `begin`.
void expect_rejected(const Names& arguments, const std::string& begin, const std::string& input = {}) {
  const Outcome outcome = run(arguments, input);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  const Names lines = lines_of(outcome.err);
  ASSERT_EQ(lines.size(), 1U) << outcome.err;
  EXPECT_TRUE(lines[0].starts_with(begin)) << lines[0];
  EXPECT_GT(lines[0].size(), "asts: "s.size());
}

struct Fault {
  const char* name;
  std::string text;
  std::string place;  ///< what stands behind "asts: FILE"
};

/// One line: test discovery reads it.
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class BadCase : public ::testing::TestWithParam<Fault> {};

TEST_P(BadCase, IsRejectedWithItsLine) {
  const TemporaryFolder folder;
  const std::string path = folder.write("bad.case", GetParam().text);
  const std::string begin = "asts: " + path + GetParam().place;
  expect_rejected({"check", path}, begin);
  expect_rejected({"check", "--final", "--format", "json", case_path("paper/refinement-figure.case"), path}, begin);
  expect_rejected({"refine", path}, begin);
  expect_rejected({"refine", "--format", "json", path}, begin);
  expect_rejected({"check", "-"}, "asts: <stdin>" + GetParam().place, GetParam().text);
}

const std::string kTwoCubes = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 2 1 1\n";

const Fault kFaults[] = {
    {"EmptyFile", "", ":1: the file is empty"},
    {"NoCase", "solid cube\n", ":1: expected the version line"},
    {"FutureVersion", "asts-case 2\n", ":1: unknown version '2'"},
    {"BinaryFile",
     "\x7F"
     "ELF\x02\x01\x01\0\0\0"s,
     ":1: "},
    {"BinaryBytesInAStep", kHeader + "refine 0 0 \xFF\xFE\n", ":5: "},
    {"HugeDegree", "asts-case 1\ndegree 3 3 99999999999999999999999999999999999999\n", ":2: "},
    {"HugeGrading", "asts-case 1\ngrading 340282366920938463463374607431768211456\n", ":2: "},
    {"HugeDomain", "asts-case 1\ndomain 100000 100000 100000\n", ":2: the initial mesh has more than"},
    {"EvenDegree", "asts-case 1\ndegree 3 4 3\n", ":2: the degree '4' is even"},
    {"DegreeOne", "asts-case 1\ndegree 1 3 3\n", ":2: "},
    {"GradingOne", "asts-case 1\ngrading 1\n", ":2: the grading '1' is below 2"},
    {"NoDomain", "asts-case 1\ndegree 3 3 3\ngrading 2\nrefine 0 0 0\n", ":4: domain is missing"},
    {"HugeMark", kHeader + "refine 0 0 " + std::string(100'000, '9') + "\n", ":5: the mark (0, 0, 999"},
    {"ZeroDenominator", kHeader + "refine 1/0 0 0\n", ":5: '1/0' has the denominator zero"},
    {"DecimalPoint", kHeader + "refine 0.5 0 0\n", ":5: '0.5' is not a number"},
    {"Exponent", kHeader + "subdivide 1e0 0 0\n", ":5: '1e0' is not a number"},
    {"TwoNumbersForAMark", kHeader + "refine 0 0\n", ":5: a mark is three numbers"},
    {"MarkOutside", kHeader + "refine 0 0 0\nrefine 0 0 33/8\n", ":6: the mark (0, 0, 33/8) lies outside"},
    {"NegativeMark", kHeader + "refine 0 -1/9 0\n", ":5: the mark (0, -1/9, 0) lies outside"},
    {"UnknownDirective", kHeader + "coarsen 0 0 0\n", ":5: unknown directive 'coarsen'"},
    {"StepsThenElements", kHeader + "refine 0 0 0\nelement 0 0 0 4 4 4\n", ":6: an element in a case with steps"},
    {"ElementsThenSteps", kHeader + "element 0 0 0 4 4 4\nsubdivide 0 0 0\n", ":6: a step in a case with elements"},
    {"EmptyBox", kTwoCubes + "element 0 0 0 2 1 1\nelement 1 0 0 1 1 1\n", ":6: the box is empty: x"},
    {"ReversedBox", kTwoCubes + "element 0 0 0 2 1 1\nelement 0 1 0 1 0 1\n", ":6: the box is empty: y"},
    {"BoxOutside", kTwoCubes + "element 0 0 0 1 1 1\nelement 1 0 0 3 1 1\n", ":6: the box reaches outside"},
    {"Gap", kTwoCubes + "element 0 0 0 1 1 1\nelement 3/2 0 0 2 1 1\n", ":"},
    {"MissingHalf", kTwoCubes + "element 0 0 0 1 1 1\n", ":"},
    {"Overlap", kTwoCubes + "element 0 0 0 1 1 1\nelement 1/2 0 0 2 1 1\n", ":"},
    {"SameBoxTwice", kTwoCubes + "element 0 0 0 2 1 1\nelement 0 0 0 2 1 1\n", ":6: "},
    {"ThinOverlap", kTwoCubes + "element 0 0 0 1000000001/1000000000 1 1\nelement 1 0 0 2 1 1\n", ":"},
};

INSTANTIATE_TEST_SUITE_P(Faults, BadCase, ::testing::ValuesIn(kFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

// Gap and overlap name a line of the file that has one of the boxes at fault.
TEST(BadMesh, NamesTheLineOfABox) {
  for (const char* boxes : {"element 0 0 0 1 1 1\nelement 3/2 0 0 2 1 1\n", "element 0 0 0 1 1 1\n",
                            "element 0 0 0 1 1 1\nelement 1/2 0 0 2 1 1\n"}) {
    const Outcome outcome = run({"check", "-"}, kTwoCubes + boxes);
    const bool named = outcome.err.starts_with("asts: <stdin>:5: ") || outcome.err.starts_with("asts: <stdin>:6: ");
    EXPECT_TRUE(named) << outcome.err;
  }
}

struct Arguments {
  const char* name;
  Names arguments;
  std::string begin = "asts: ";
};

/// One line: test discovery reads it.
void PrintTo(const Arguments& arguments, std::ostream* out) { *out << arguments.name; }

class BadCommandLine : public ::testing::TestWithParam<Arguments> {};

TEST_P(BadCommandLine, IsRejected) { expect_rejected(GetParam().arguments, GetParam().begin); }

const std::string kGood = case_path("paper/example-2.10-m16.case");

const Arguments kCommandLines[] = {
    {"NoCommand", {}, "asts: no command is given"},
    {"EmptyCommand", {""}, "asts: unknown command ''"},
    {"UnknownCommand", {"refuse", kGood}, "asts: unknown command 'refuse'"},
    {"UnknownOption", {"check", "--fast", kGood}},
    {"UnknownGlobalOption", {"--fast"}},
    {"CheckWithoutCase", {"check"}},
    {"RefineWithoutCase", {"refine", "--format", "json"}},
    {"RefineTwoCases", {"refine", kGood, kGood}},
    {"ValidateWithoutFile", {"validate"}},
    {"GenerateWithoutWorkload", {"generate"}},
    {"UnknownFormat", {"check", "--format", "xml", kGood}, "asts: --format: xml not in {text,json}"},
    {"FormatWithoutValue", {"check", kGood, "--format"}},
    {"UnknownProperty", {"check", "--property", "pretty", kGood}, "asts: no property is called 'pretty'"},
    {"OneUnknownProperty", {"check", "--property", "admissible", "--property", "", kGood}},
    {"PropertyWithoutValue", {"check", kGood, "--property"}},
    {"NegativeBudget", {"check", "--budget", "-1", kGood}},
    {"ZeroBudget", {"check", "--budget", "0", kGood}},
    {"NoNumberAsBudget", {"check", "--budget", "many", kGood}},
    {"WriteWithoutFile", {"refine", kGood, "--write"}},
    {"MissingFile", {"check", "/nowhere/a.case"}, "asts: /nowhere/a.case: cannot be read: No such file"},
    {"MissingSecondFile", {"check", kGood, "/nowhere/a.case"}, "asts: /nowhere/a.case: cannot be read: No such file"},
    {"RefineMissingFile", {"refine", "/nowhere/a.case"}, "asts: /nowhere/a.case: cannot be read: No such file"},
    {"Directory", {"check", "/tmp"}, "asts: /tmp: cannot be read: Is a directory"},
    {"RefineDirectory", {"refine", "/tmp"}, "asts: /tmp: cannot be read: Is a directory"},
    {"EmptyName", {"check", ""}, "asts: : cannot be read"},
    {"NameOfTwoLines", {"check", "a\nb"}, "asts: a\\x0Ab: cannot be read"},
    {"UnknownWorkload", {"generate", "cube"}},
    {"TwoDegrees", {"generate", "corner", "--degree", "3,3"}, "asts: --degree takes three numbers"},
    {"FourDegrees", {"generate", "corner", "--degree", "3,3,3,3"}, "asts: --degree takes three numbers"},
    {"EvenDegree", {"generate", "corner", "--degree", "3,4,3"}, "asts: the degree '4' is even"},
    {"NoDegree", {"generate", "corner", "--degree", "a,b,c"}},
    {"GradingOne", {"generate", "corner", "--grading", "1"}, "asts: the grading '1' is below 2"},
    {"HugeGrading", {"generate", "corner", "--grading", "99999999999999999999"}},
    {"EmptyDomain", {"generate", "corner", "--domain", "0,4,4"}, "asts: the domain size '0' is below 1"},
    {"HugeDomain", {"generate", "corner", "--domain", "100000,100000,100000"}, "asts: the initial mesh has more than"},
    {"NoElements", {"generate", "sphere", "--elements", "0"}, "asts: --elements takes"},
    {"NegativeElements", {"generate", "sphere", "--elements", "-5"}, "asts: --elements takes"},
    {"TooManyElements", {"generate", "sphere", "--elements", "1000000000000"}, "asts: --elements takes"},
    {"ElementsAsADecimal", {"generate", "sphere", "--elements", "1e6"}},
};

INSTANTIATE_TEST_SUITE_P(CommandLines, BadCommandLine, ::testing::ValuesIn(kCommandLines),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST(Help, IsOnStdout) {
  for (const Names& arguments : {Names{"--help"}, Names{"check", "--help"}, Names{"refine", "--help"},
                                 Names{"generate", "--help"}, Names{"validate", "--help"}, Names{"--version"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
  }
}

}  // namespace
}  // namespace asts::testing
