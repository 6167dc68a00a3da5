#include "reports/case_snippet.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts::testing {
namespace {

const std::string kFindings = std::string(ASTS_CASES) + "/../../reports/findings/";

struct Outcome {
  int exit_code;
  std::string out;
};

/// Runs a program that tests/reports/snippets built of a snippet.
Outcome run_snippet(const std::string& name) {
  FILE* pipe = popen((std::string("'") + ASTS_SNIPPETS + "/" + name + "'").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error(name + " cannot be started");
  std::string out;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) out += static_cast<char>(c);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128, out};
}

TEST(CaseSnippet, OfStepsSaysThatItsCaseViolates) {
  const Outcome outcome = run_snippet("snippet_of_steps");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "as-implies-dc: violated: no-partial-overlap\n");
}

TEST(CaseSnippet, OfBoxesSaysThatItsCaseViolates) {
  const Outcome outcome = run_snippet("snippet_of_boxes");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "admissible: violated: outside-class\n");
}

TEST(CaseSnippet, OfACaseThatDoesNotViolateExitsWith1) {
  const Outcome outcome = run_snippet("snippet_of_nothing");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "dual-compatible: not violated\n");
}

TEST(CaseSnippet, IsShort) {
  const Case test_case = read_case_file(kFindings + "as-implies-dc.case");
  EXPECT_EQ(
      case_snippet(test_case, find_statement("dual-compatible").value()),
      R"(// dual-compatible (Definition 6.4): any two active nodes whose supports share volume have index vectors that
// overlap along two axes at least
// Exits with 0 if the case below violates it.
#include <cstdio>

#include "properties/statement.hpp"

using namespace asts;

// numerator/denominator, in lowest terms
static CompactRational q(std::int64_t numerator, std::int64_t denominator = 1) {
  return CompactRational::lowest_terms(numerator, denominator);
}

int main() {
  Case test_case;
  test_case.degree = {3, 3, 3};
  test_case.grading = 2;
  test_case.domain = {4, 4, 5};
  test_case.steps.push_back({Step::Kind::subdivide, {Point{q(1), q(1), q(1)}}});
  test_case.steps.push_back({Step::Kind::subdivide, {Point{q(3, 2), q(1), q(1)}}});
  const auto kind = violation_of(find_statement("dual-compatible").value(), test_case);
  std::printf("dual-compatible: %s\n", kind ? ("violated: " + *kind).c_str() : "not violated");
  return kind == "no-partial-overlap" ? 0 : 1;
}
)");
}

// Several marks stand on lines of their own; numbers beyond 64 bits are exact.
TEST(CaseSnippet, WritesMarksAndBigNumbersExactly) {
  const Case test_case = parse_case(
      "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\nrefine 0 1/2 1  1/100000000000000000003 2 3\n", "case");
  const std::string text = case_snippet(test_case, find_statement("dual-basis").value(), "lambda-not-delta");
  EXPECT_NE(text.find("  test_case.steps.push_back({Step::Kind::refine, {\n"
                      "      Point{q(0), q(1, 2), q(1)},\n"
                      "      Point{big(\"1/100000000000000000003\"), q(2), q(3)}}});\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("static CompactRational big("), std::string::npos) << text;
}

// No function that nothing calls, which compilers warn of.
TEST(CaseSnippet, DefinesWhatItNeeds) {
  const Case test_case = parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n", "case");
  const std::string text = case_snippet(test_case, find_statement("dual-basis").value(), "lambda-not-delta");
  EXPECT_EQ(text.find("static"), std::string::npos) << text;
}

TEST(CaseSnippet, RefusesACaseThatDoesNotViolate) {
  const Case test_case = read_case_file(kFindings + "dc-implies-as.case");
  EXPECT_THROW(case_snippet(test_case, find_statement("dual-compatible").value()), InputError);
}

}  // namespace
}  // namespace asts::testing
