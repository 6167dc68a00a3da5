#include "lib/mesh/case_file.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <ostream>

namespace asts {
namespace {

using namespace std::string_literals;

const std::string kHeader = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 5\n";

std::string message_of(const std::string& text) {
  try {
    parse_case(text, "f");
  } catch (const CaseFileError& error) {
    return error.what();
  }
  return "no error";
}

CompactRational number(std::int64_t numerator, std::int64_t denominator = 1) {
  return CompactRational(Rational(numerator, denominator));
}

struct Fault {
  const char* name;
  std::string text;
  std::string message;
};

/// One line: test discovery reads it.
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.message; }

class CaseFault : public testing::TestWithParam<Fault> {};

TEST_P(CaseFault, IsNamedWithItsLine) { EXPECT_EQ(message_of(GetParam().text), GetParam().message); }

const Fault kFaults[] = {
    {"Empty", "", "f:1: the file is empty: expected the version line 'asts-case 1'"},
    {"OnlyComments", "# a\n\n# b\n", "f:3: the file is empty: expected the version line 'asts-case 1'"},
    {"NoVersion", "degree 3 3 3\n", "f:1: expected the version line 'asts-case 1', found 'degree'"},
    {"VersionNotFirst", "# a\ngrading 2\nasts-case 1\n",
     "f:2: expected the version line 'asts-case 1', found 'grading'"},
    {"OtherVersion", "asts-case 2\n", "f:1: unknown version '2': only version 1 can be read"},
    {"VersionWithoutNumber", "asts-case\n", "f:1: asts-case needs one version number, found 0"},
    {"VersionWithMore", "asts-case 1 1\n", "f:1: asts-case needs one version number, found 2"},
    {"VersionTwice", "asts-case 1\nasts-case 1\n", "f:2: a second version line"},
    {"NothingBehindVersion", "asts-case 1\n", "f:1: degree is missing: it comes after the version line"},
    {"DegreeMissing", "asts-case 1\ngrading 2\ndomain 4 4 5\nrefine\n",
     "f:4: degree is missing: it comes after the version line"},
    {"GradingMissing", "asts-case 1\ndegree 3 3 3\ndomain 4 4 5\nelement 0 0 0 1 1 1\n",
     "f:4: grading is missing: it comes after the version line"},
    {"DomainMissing", "asts-case 1\ndegree 3 3 3\ngrading 2\n\n",
     "f:4: domain is missing: it comes after the version line"},
    {"DegreeTwice", kHeader + "degree 3 3 3\n", "f:5: degree is given twice"},
    {"GradingTwice", kHeader + "grading 3\n", "f:5: grading is given twice"},
    {"DomainTwice", kHeader + "domain 4 4 5\n", "f:5: domain is given twice"},
    {"HeaderAfterStep", kHeader + "refine\ndegree 3 3 3\n", "f:6: degree must come before the steps and elements"},
    {"HeaderAfterElement", kHeader + "element 0 0 0 1 1 1\ngrading 2\n",
     "f:6: grading must come before the steps and elements"},
    {"UnknownDirective", kHeader + "Refine 0 0 0\n", "f:5: unknown directive 'Refine'"},
    {"ControlCharacters", kHeader + "\x1B[2Jrefine\x7F\xC3\xA4\v\n",
     R"(f:5: unknown directive '\x1B[2Jrefine\x7F\xC3\xA4\x0B')"},
    {"DegreeCount", "asts-case 1\ndegree 3 3\n", "f:2: degree needs three numbers, found 2"},
    {"GradingCount", "asts-case 1\ngrading 2 2\n", "f:2: grading needs one number, found 2"},
    {"DomainCount", "asts-case 1\ndomain 4 4 5 6\n", "f:2: domain needs three numbers, found 4"},
    {"ElementCount", kHeader + "element 0 0 0 1 1\n", "f:5: element needs six numbers, found 5"},
    {"MarkCount", kHeader + "refine 0 0 0  1 1\n", "f:5: a mark is three numbers: 5 is not a multiple of 3"},
    {"Decimal", kHeader + "refine 0.5 0 0\n", "f:5: '0.5' is not a number: expected an integer or a/b"},
    {"Plus", kHeader + "refine +1 0 0\n", "f:5: '+1' is not a number: expected an integer or a/b"},
    {"Letters", kHeader + "refine one 0 0\n", "f:5: 'one' is not a number: expected an integer or a/b"},
    {"SignBehindSlash", kHeader + "refine 1/-2 0 0\n", "f:5: '1/-2' is not a number: expected an integer or a/b"},
    {"NothingBehindSlash", kHeader + "refine 1/ 0 0\n", "f:5: '1/' is not a number: expected an integer or a/b"},
    {"TwoSlashes", kHeader + "refine 1/2/0 0 0\n", "f:5: '1/2/0' is not a number: expected an integer or a/b"},
    {"ZeroDenominator", kHeader + "refine 1/0 0 0\n", "f:5: '1/0' has the denominator zero"},
    {"LongZeroDenominator", kHeader + "refine 1/"s + std::string(50, '0') + " 0 0\n",
     "f:5: '1/0000000000000000000000... (52 characters)' has the denominator zero"},
    {"EvenDegree", "asts-case 1\ndegree 3 4 3\n", "f:2: the degree '4' is even: degrees are odd"},
    {"SmallDegree", "asts-case 1\ndegree 3 3 1\n", "f:2: the degree '1' is below 3"},
    {"LargeDegree", "asts-case 1\ndegree 1000003 3 3\n", "f:2: the degree '1000003' is above 1000001"},
    {"BrokenDegree", "asts-case 1\ndegree 7/2 3 3\n", "f:2: the degree '7/2' is not an integer"},
    {"EndlessDegree", "asts-case 1\ndegree " + std::string(1'000'000, '7') + " 3 3\n",
     "f:2: the degree '777777777777777777777777... (1000000 characters)' is above 1000001"},
    {"SmallGrading", "asts-case 1\ngrading 1\n", "f:2: the grading '1' is below 2"},
    {"NegativeGrading", "asts-case 1\ngrading -2\n", "f:2: the grading '-2' is below 2"},
    {"LargeGrading", "asts-case 1\ngrading 1000001\n", "f:2: the grading '1000001' is above 1000000"},
    {"SmallDomain", "asts-case 1\ndomain 4 0 5\n", "f:2: the domain size '0' is below 1"},
    {"LargeDomain", "asts-case 1\ndomain 100000001 1 1\n", "f:2: the domain size '100000001' is above 100000000"},
    {"ManyElements", "asts-case 1\ndomain 100000 1001 1\n", "f:2: the initial mesh has more than 100000000 elements"},
    {"MarkBelow", kHeader + "refine 1 1 1 0 -1/99 0\n",
     "f:5: the mark (0, -1/99, 0) lies outside the domain [0,4] x [0,4] x [0,5]"},
    {"MarkAbove", kHeader + "subdivide 4 4 36893488147419103233/7378697629483820646\n",
     "f:5: the mark (4, 4, 36893488147419103233/7378697629483820646) lies outside the domain [0,4] x [0,4] x [0,5]"},
    {"ElementAfterStep", kHeader + "refine\nelement 0 0 0 1 1 1\n",
     "f:6: an element in a case with steps: a case has steps or elements, not both"},
    {"StepAfterElement", kHeader + "element 0 0 0 1 1 1\nsubdivide\n",
     "f:6: a step in a case with elements: a case has steps or elements, not both"},
    {"EmptyBox", kHeader + "element 0 1/2 0  1 2/4 1\n", "f:5: the box is empty: y runs from '1/2' to '2/4'"},
    {"BoxOutside", kHeader + "element 3 0 0  5 1 1\n", "f:5: the box reaches outside the domain [0,4] x [0,4] x [0,5]"},
    {"InvalidUtf8", kHeader + "# \xE4\n", "f:5: invalid UTF-8"},
    {"OverlongUtf8", "# fine: \xC3\xA4 \xE2\x88\x9E \xF0\x9F\x98\x80\n# \xC0\xAF\n", "f:2: invalid UTF-8"},
    {"CutUtf8", "asts-case 1 # \xE2\x88", "f:1: invalid UTF-8"},
    {"Binary",
     "\x7F"
     "ELF\x02\x01\0\0"s,
     "f:1: a NUL byte: this is not a text file"},
    {"NulInComment", kHeader + "# \0\n"s, "f:5: a NUL byte: this is not a text file"},
    {"FirstFaultWins", "asts-case 1\ngrading 1\n\xFF\n", "f:2: the grading '1' is below 2"},
};

INSTANTIATE_TEST_SUITE_P(CaseFile, CaseFault, testing::ValuesIn(kFaults),
                         [](const auto& fault) { return std::string(fault.param.name); });

TEST(CaseFile, ReadsTheContractsExample) {
  const Case read = parse_case(
      "# a comment\n\nasts-case 1\ndomain 4 4 5   # the initial mesh\ngrading 2\ndegree 3 5 3\n"
      "refine 1/4 1/4 1/4  5/2 1/2 1/2     # two marks\nsubdivide 3/2 3/2 6/4\nrefine#no mark\n",
      "f");
  Case expected{.degree = {3, 5, 3}, .grading = 2, .domain = {4, 4, 5}, .steps = {}, .elements = {}};
  expected.steps = {
      {Step::Kind::refine, {{number(1, 4), number(1, 4), number(1, 4)}, {number(5, 2), number(1, 2), number(1, 2)}}},
      {Step::Kind::subdivide, {{number(3, 2), number(3, 2), number(3, 2)}}},
      {Step::Kind::refine, {}}};
  EXPECT_EQ(read, expected);
}

TEST(CaseFile, ReadsElementsWithTheirLines) {
  const Case read = parse_case(kHeader + "\nelement 0 0 0  1/2 1 1\n# b\nelement 1/2 0 0  4 4 5", "f");
  ASSERT_EQ(read.elements.size(), 2U);
  EXPECT_TRUE(read.explicit_mesh);
  EXPECT_EQ(read.elements[0].line, 6U);
  EXPECT_EQ(read.elements[1].line, 8U);
  EXPECT_EQ(read.elements[1].lower, (Point{number(1, 2), number(0), number(0)}));
  EXPECT_EQ(read.elements[1].upper, (Point{number(4), number(4), number(5)}));
}

TEST(CaseFile, AcceptsTheInitialMeshAlone) { EXPECT_TRUE(parse_case(kHeader, "f").steps.empty()); }

TEST(CaseFile, AcceptsWhatEditorsMakeOfIt) {
  const std::string text =
      "\xEF\xBB\xBF"
      "asts-case 1\r\n\r\n\tdegree\t3 3 3 \r\ngrading 2#m\r\ndomain 4 4 5\r\nrefine 4 4 5";
  EXPECT_EQ(parse_case(text, "f"), parse_case(kHeader + "refine 4 4 5\n", "f"));
}

TEST(CaseFile, AcceptsTheLargestSizes) {
  const Case read = parse_case("asts-case 1\ndegree 1000001 3 3\ngrading 1000000\ndomain 10000 10000 1\n", "f");
  EXPECT_EQ(read.degree[0], kMaxDegree);
  EXPECT_EQ(read.grading, kMaxGrading);
}

std::string file_message_of(const std::string& path) {
  try {
    read_case_file(path);
  } catch (const CaseFileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(CaseFile, NamesFilesThatCannotBeRead) {
  const std::string folder = testing::TempDir();
  EXPECT_EQ(file_message_of(folder), folder + ": cannot be read: Is a directory");
  EXPECT_EQ(file_message_of("no/such.case"), "no/such.case: cannot be read: No such file or directory");
  // Unreadable for root too, whom file permissions do not stop.
  EXPECT_EQ(file_message_of("/proc/self/mem"), "/proc/self/mem: cannot be read: Input/output error");
  EXPECT_EQ(file_message_of("/dev/zero"), "/dev/zero:1: a NUL byte: this is not a text file");
}

TEST(CaseFile, ReadsEveryCaseOfTheRepository) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ASTS_CASES)) {
    if (entry.path().extension() != ".case") continue;
    EXPECT_NO_THROW(read_case_file(entry.path().string())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 6U);
}

TEST(CaseFile, ReadsAMillionMarksInNoTime) {
  std::string text = kHeader + "refine";
  for (int i = 0; i < 1'000'000; ++i) text += " " + std::to_string(i % 4096) + "/1024 1/3 35/16";
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(parse_case(text, "f").steps.at(0).marks.size(), 1'000'000U);
  // 0.2 s when optimised; the bound only tells linear from quadratic.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

}  // namespace
}  // namespace asts
