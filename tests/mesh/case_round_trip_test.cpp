#include <gtest/gtest.h>
// rapidcheck's header needs gtest's before it.
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <ostream>

#include "lib/mesh/case_file.hpp"

namespace asts {

/// What rapidcheck prints for a case: its text. Outside the unnamed namespace, where it looks for it.
static void showValue(const Case& test_case, std::ostream& out) { out << write_case(test_case); }

namespace {

/// A number between 0 and `bound`: on a coarse grid, near the border of 64 bits, or far beyond it.
rc::Gen<CompactRational> coordinate(int bound) {
  const auto of_grid = [bound](const Rational& denominator) {
    return rc::gen::map(rc::gen::inRange<std::int64_t>(0, 1'000'001), [=](std::int64_t share) {
      const Integer wanted = numerator(denominator) * bound * share / 1'000'000;
      return CompactRational(Rational(wanted) / denominator);
    });
  };
  const Rational long_one(Integer(7) * boost::multiprecision::pow(Integer(10), 60));
  return rc::gen::mapcat(rc::gen::element(Rational(1), Rational(2), Rational(27), Rational(Integer(1) << 62),
                                          Rational(Integer(1) << 63), Rational(Integer(1) << 64), long_one),
                         of_grid);
}

rc::Gen<Point> point(const PerAxis<int>& domain) {
  return rc::gen::apply(
      [](const CompactRational& x, const CompactRational& y, const CompactRational& z) {
        return Point{x, y, z};
      },
      coordinate(domain[0]), coordinate(domain[1]), coordinate(domain[2]));
}

/// A non-empty box: a random lower corner (moved down from the upper border), the upper corner at the border.
ElementLine random_element(const PerAxis<int>& domain) {
  ElementLine box{*point(domain), {}, 0};
  for (std::size_t axis = 0; axis < domain.size(); ++axis) {
    box.upper[axis] = CompactRational(domain[axis]);
    if (box.lower[axis] == box.upper[axis]) box.lower[axis] = CompactRational(0);
  }
  return box;
}

Case drawn_case() {
  Case result;
  for (int& degree : result.degree) degree = 2 * *rc::gen::inRange(1, 9) + 1;
  result.grading = *rc::gen::inRange(2, 20);
  for (int& size : result.domain) size = *rc::gen::inRange(1, 465);  // 464^3 < 10^8
  const int count = *rc::gen::inRange(0, 6);
  result.explicit_mesh = count > 0 && *rc::gen::arbitrary<bool>();
  for (int i = 0; i < count; ++i) {
    if (result.explicit_mesh) {
      result.elements.push_back(random_element(result.domain));
      continue;
    }
    const auto kind = *rc::gen::element(Step::Kind::refine, Step::Kind::subdivide);
    result.steps.push_back({kind, *rc::gen::container<std::vector<Point>>(point(result.domain))});
  }
  return result;
}

/// Drawn as one value, so that a failure prints the text of the case and not the numbers it was made of.
Case random_case() { return *rc::gen::exec(drawn_case); }

/// The text as another hand would write it: CRLF, comments, free lines, more blanks.
std::string drawn_dress(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const int what = *rc::gen::inRange(0, 4);
    if (c == '\n') {
      result += what == 0 ? "\r\n" : what == 1 ? " # \xC3\xA4 1 2\n" : what == 2 ? "\n\t\n#\n" : "\n";
    } else {
      result += c == ' ' && what == 0 ? "\t " : std::string(1, c);
    }
  }
  return result;
}

/// One value too. It keeps the text by value: shrinking runs it again, later.
std::string dressed(const std::string& text) {
  return *rc::gen::exec([text] { return drawn_dress(text); });
}

RC_GTEST_PROP(CaseRoundTrip, WrittenCasesReadBackEqual, ()) {
  const Case original = random_case();
  const std::string text = write_case(original);
  const Case read = parse_case(text, "f");
  RC_ASSERT(read == original);
  RC_ASSERT(write_case(read) == text);
}

RC_GTEST_PROP(CaseRoundTrip, BlanksAndCommentsMeanNothing, ()) {
  const Case original = random_case();
  const std::string text = dressed(write_case(original));
  RC_LOG() << text;
  RC_ASSERT(parse_case(text, "f") == original);
}

/// Whatever bytes come, the reader gives a case that it can write and read, or names a line that exists.
RC_GTEST_PROP(CaseRoundTrip, DamagedTextIsReadOrRefused, ()) {
  std::string text = write_case(random_case());
  const auto damages = *rc::gen::container<std::vector<std::pair<std::size_t, char>>>(
      rc::gen::pair(rc::gen::inRange<std::size_t>(0, text.size()),
                    rc::gen::oneOf(rc::gen::arbitrary<char>(), rc::gen::elementOf(std::string("0123/-# \n\r")))));
  for (const auto& [at, byte] : damages) text[at] = byte;
  RC_LOG() << text;
  try {
    const Case read = parse_case(text, "f");
    RC_ASSERT(parse_case(write_case(read), "f") == read);
  } catch (const CaseFileError& error) {
    const std::string what = error.what();
    RC_LOG() << what;
    RC_ASSERT(what.starts_with("f:"));
    const std::size_t line = std::stoul(what.substr(2));
    const auto newlines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    RC_ASSERT(line >= 1 && line <= newlines + 1);
  }
}

}  // namespace
}  // namespace asts
