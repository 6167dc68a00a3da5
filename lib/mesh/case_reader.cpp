#include <span>
#include <utility>

#include "lib/mesh/case_file.hpp"
#include "lib/mesh/case_numbers.hpp"
#include "lib/mesh/case_text.hpp"

namespace asts {
namespace {

constexpr std::string_view kVersion = "1";

std::string joined(const PerAxis<std::string>& values, const char* separator) {
  return values[0] + separator + values[1] + separator + values[2];
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : lines_(text, name) {}

  Case read() {
    read_version();
    while (lines_.next()) read_directive();
    require_header();
    return std::move(case_);
  }

 private:
  void read_version();
  void read_directive();
  void read_header(const std::string& directive, std::string_view rest, bool& given);
  void read_step(std::string_view directive, std::string_view rest);
  void read_element(std::string_view rest);
  void read_degree(std::string_view rest);
  void read_grading(std::string_view rest);
  void read_domain(std::string_view rest);

  void require_header() const;
  Point point(std::span<const std::string_view> words) const;
  bool in_domain(const Point& point) const;
  std::string domain_text() const;

  CaseLines lines_;
  Case case_;
  bool has_degree_ = false;
  bool has_grading_ = false;
  bool has_domain_ = false;
};

void Reader::read_version() {
  if (!lines_.next()) lines_.fail("the file is empty: expected the version line 'asts-case 1'");
  std::array<std::string_view, 2> words;
  const std::size_t count = split(lines_.line(), words);
  if (words[0] != "asts-case") lines_.fail("expected the version line 'asts-case 1', found " + quote(words[0]));
  require_count(lines_, count - 1, 1, "asts-case needs one version number");
  if (words[1] != kVersion) lines_.fail("unknown version " + quote(words[1]) + ": only version 1 can be read");
}

void Reader::read_directive() {
  std::string_view rest = lines_.line();
  const std::string_view directive = next_word(rest);
  if (directive == "refine" || directive == "subdivide") return read_step(directive, rest);
  if (directive == "element") return read_element(rest);
  if (directive == "degree") return read_header("degree", rest, has_degree_);
  if (directive == "grading") return read_header("grading", rest, has_grading_);
  if (directive == "domain") return read_header("domain", rest, has_domain_);
  if (directive == "asts-case") lines_.fail("a second version line");
  lines_.fail("unknown directive " + quote(directive));
}

void Reader::read_header(const std::string& directive, std::string_view rest, bool& given) {
  if (case_.explicit_mesh || !case_.steps.empty()) lines_.fail(directive + " must come before the steps and elements");
  if (given) lines_.fail(directive + " is given twice");
  given = true;
  if (directive == "degree") {
    read_degree(rest);
  } else if (directive == "grading") {
    read_grading(rest);
  } else {
    read_domain(rest);
  }
}

void Reader::read_degree(std::string_view rest) {
  std::array<std::string_view, kDimension> words;
  require_count(lines_, split(rest, words), words.size(), "degree needs three numbers");
  for (std::size_t axis = 0; axis < words.size(); ++axis) {
    case_.degree[axis] = integer_in(lines_, "degree", words[axis], 3, kMaxDegree);
    if (case_.degree[axis] % 2 == 0) lines_.fail("the degree " + quote(words[axis]) + " is even: degrees are odd");
  }
}

void Reader::read_grading(std::string_view rest) {
  std::array<std::string_view, 1> words;
  require_count(lines_, split(rest, words), words.size(), "grading needs one number");
  case_.grading = integer_in(lines_, "grading", words[0], 2, kMaxGrading);
}

void Reader::read_domain(std::string_view rest) {
  std::array<std::string_view, kDimension> words;
  require_count(lines_, split(rest, words), words.size(), "domain needs three numbers");
  std::int64_t elements = 1;
  for (std::size_t axis = 0; axis < words.size(); ++axis) {
    case_.domain[axis] = integer_in(lines_, "domain size", words[axis], 1, kMaxInitialElements);
    elements *= case_.domain[axis];  // at most 10^8 * 10^8 before the check
    if (elements > kMaxInitialElements) {
      lines_.fail("the initial mesh has more than " + std::to_string(kMaxInitialElements) + " elements");
    }
  }
}

void Reader::read_step(std::string_view directive, std::string_view rest) {
  require_header();
  if (case_.explicit_mesh) lines_.fail("a step in a case with elements: a case has steps or elements, not both");
  Step& step = case_.steps.emplace_back();
  step.kind = directive == "refine" ? Step::Kind::refine : Step::Kind::subdivide;
  const std::size_t count = split(rest, {});
  if (count % kDimension != 0) {
    lines_.fail("a mark is three numbers: " + std::to_string(count) + " is not a multiple of 3");
  }
  step.marks.reserve(count / kDimension);
  PerAxis<std::string_view> words;
  while (!(words[0] = next_word(rest)).empty()) {
    for (std::size_t axis = 1; axis < words.size(); ++axis) words[axis] = next_word(rest);
    step.marks.push_back(point(words));
    if (in_domain(step.marks.back())) continue;
    const std::string mark = joined({shown(words[0]), shown(words[1]), shown(words[2])}, ", ");
    lines_.fail("the mark (" + mark + ") lies outside the domain " + domain_text());
  }
}

void Reader::read_element(std::string_view rest) {
  require_header();
  if (!case_.steps.empty()) lines_.fail("an element in a case with steps: a case has steps or elements, not both");
  std::array<std::string_view, std::size_t{2} * kDimension> words;
  require_count(lines_, split(rest, words), words.size(), "element needs six numbers");
  case_.explicit_mesh = true;
  const std::span<const std::string_view> all(words);
  const ElementLine& box = case_.elements.emplace_back(
      ElementLine{point(all.first(kDimension)), point(all.last(kDimension)), lines_.number()});
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (less(box.lower[axis], box.upper[axis])) continue;
    lines_.fail(std::string("the box is empty: ") + axis_name(static_cast<Axis>(axis)) + " runs from " +
                quote(words[axis]) + " to " + quote(words[axis + kDimension]));
  }
  if (!in_domain(box.lower) || !in_domain(box.upper)) {
    lines_.fail("the box reaches outside the domain " + domain_text());
  }
}

void Reader::require_header() const {
  const char* missing = !has_degree_ ? "degree" : !has_grading_ ? "grading" : !has_domain_ ? "domain" : nullptr;
  if (missing) lines_.fail(std::string(missing) + " is missing: it comes after the version line");
}

Point Reader::point(std::span<const std::string_view> words) const {
  Point result;
  for (std::size_t axis = 0; axis < result.size(); ++axis) result[axis] = number_in(lines_, words[axis]);
  return result;
}

bool Reader::in_domain(const Point& point) const {
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    const CompactRational& coordinate = point[axis];
    if (less(coordinate, CompactRational(0)) || less(CompactRational(case_.domain[axis]), coordinate)) return false;
  }
  return true;
}

std::string Reader::domain_text() const {
  PerAxis<std::string> intervals;
  for (std::size_t axis = 0; axis < intervals.size(); ++axis) {
    intervals[axis] = "[0," + std::to_string(case_.domain[axis]) + "]";
  }
  return joined(intervals, " x ");
}

}  // namespace

Case parse_case(std::string_view text, const std::string& name) { return Reader(text, name).read(); }

}  // namespace asts
