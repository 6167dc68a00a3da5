#include "reports/case_snippet.hpp"

#include <fmt/format.h>

#include <sstream>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

constexpr std::size_t kWidth = 110;

std::string number(const CompactRational& value) {
  if (!value.is_small()) return fmt::format("big(\"{}\")", to_string(value.value()));
  if (value.denominator() == 1) return fmt::format("q({})", value.numerator());
  return fmt::format("q({}, {})", value.numerator(), value.denominator());
}

std::string point(const Point& point) {
  std::string result;
  for (const CompactRational& value : point) result += (result.empty() ? "Point{" : ", ") + number(value);
  return result + "}";
}

/// Whether some of the case's points has a number that needs big(), or one that needs q().
struct NumberKinds {
  bool big = false;
  bool small = false;

  void see(const Point& point) {
    for (const CompactRational& value : point) (value.is_small() ? small : big) = true;
  }
};

NumberKinds number_kinds(const Case& test_case) {
  NumberKinds kinds;
  for (const Step& step : test_case.steps) {
    for (const Point& mark : step.marks) kinds.see(mark);
  }
  for (const ElementLine& element : test_case.elements) {
    kinds.see(element.lower);
    kinds.see(element.upper);
  }
  return kinds;
}

/// As the contents of a string literal.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

/// Words in lines of a comment, each of them ended by something that no backslash can join to the next one.
std::string comment(const std::string& text) {
  std::istringstream words(text);
  std::string result;
  std::string line = "//";
  for (std::string word; words >> word;) {
    if (word.back() == '\\') word += '.';
    if (line.size() + 1 + word.size() > kWidth) {
      result += line + "\n";
      line = "//";
    }
    line += " " + word;
  }
  return result + line + "\n";
}

std::string opening(const Statement& statement) {
  const bool claim = statement.claim != nullptr;
  return comment(fmt::format("{} ({}): {}", statement.id(),
                             claim ? statement.claim->source : statement.property->source,
                             claim ? statement.claim->statement : statement.property->statement)) +
         "// Exits with 0 if the case below violates it.\n"
         "#include <cstdio>\n\n"
         "#include \"properties/statement.hpp\"\n\n"
         "using namespace asts;\n\n";
}

std::string number_functions(const NumberKinds& kinds) {
  std::string result;
  if (kinds.small) {
    result +=
        "// numerator/denominator, in lowest terms\n"
        "static CompactRational q(std::int64_t numerator, std::int64_t denominator = 1) {\n"
        "  return CompactRational::lowest_terms(numerator, denominator);\n"
        "}\n\n";
  }
  if (kinds.big) {
    result +=
        "// a number beyond 64 bits, in lowest terms\n"
        "static CompactRational big(const char* digits) { return CompactRational(Rational(digits)); }\n\n";
  }
  return result;
}

std::string setting(const Case& test_case) {
  const auto triple = [](const PerAxis<int>& values) { return fmt::format("{{{}}}", fmt::join(values, ", ")); };
  return fmt::format("  test_case.degree = {};\n  test_case.grading = {};\n  test_case.domain = {};\n",
                     triple(test_case.degree), test_case.grading, triple(test_case.domain));
}

/// One step; its marks a line each when there are several.
std::string step(const Step& step) {
  const char* name = step.kind == Step::Kind::refine ? "refine" : "subdivide";
  std::string result = fmt::format("  test_case.steps.push_back({{Step::Kind::{}, {{", name);
  for (std::size_t i = 0; i < step.marks.size(); ++i) {
    result += (i == 0 ? "" : ",") + std::string(step.marks.size() > 1 ? "\n      " : "") + point(step.marks[i]);
  }
  return result + "}});\n";
}

std::string mesh(const Case& test_case) {
  std::string result;
  for (const Step& one : test_case.steps) result += step(one);
  if (test_case.explicit_mesh) result += "  test_case.explicit_mesh = true;\n";
  for (const ElementLine& one : test_case.elements) {
    result += fmt::format("  test_case.elements.push_back({{{}, {}}});\n", point(one.lower), point(one.upper));
  }
  return result;
}

}  // namespace

std::string case_snippet(const Case& test_case, const Statement& statement, const std::string& kind) {
  const std::string id = escaped(statement.id());
  return opening(statement) + number_functions(number_kinds(test_case)) + "int main() {\n  Case test_case;\n" +
         setting(test_case) + mesh(test_case) +
         fmt::format(
             "  const auto kind = violation_of(find_statement(\"{0}\").value(), test_case);\n"
             "  std::printf(\"{0}: %s\\n\", kind ? (\"violated: \" + *kind).c_str() : \"not violated\");\n"
             "  return kind == \"{1}\" ? 0 : 1;\n"
             "}}\n",
             id, escaped(kind));
}

std::string case_snippet(const Case& test_case, const Statement& statement) {
  const std::optional<std::string> kind = violation_of(statement, test_case);
  if (!kind) throw InputError(std::string("the case does not violate ") + statement.id());
  return case_snippet(test_case, statement, *kind);
}

}  // namespace asts
