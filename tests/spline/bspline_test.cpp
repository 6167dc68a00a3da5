#include "lib/spline/bspline.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lib/exact/rational.hpp"
#include "lib/exact/residue.hpp"

namespace asts {
namespace {

using Vector = std::vector<Rational>;
using Ranks = std::vector<std::int32_t>;

Rational ratio(int a, int b) { return Rational(a, b); }

/// Strictly increasing lines.
Vector any_lines(std::size_t count) {
  Vector lines{0};
  while (lines.size() < count) lines.push_back(lines.back() + ratio(*rc::gen::inRange(1, 9), *rc::gen::inRange(1, 5)));
  return lines;
}

/// `length` of the ranks 0, ..., count - 1, ascending.
Ranks any_ranks(std::size_t count, std::size_t length) {
  Ranks ranks;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t wanted = length - ranks.size(), left = count - i;
    if (wanted > 0 && *rc::gen::inRange<std::size_t>(0, left) < wanted) ranks.push_back(static_cast<std::int32_t>(i));
  }
  return ranks;
}

Vector at_lines(const Vector& lines, const Ranks& ranks) {
  Vector result;
  for (const std::int32_t rank : ranks) result.push_back(lines[static_cast<std::size_t>(rank)]);
  return result;
}

/// The definition: divided differences of truncated powers, (x_(p+2) - x_1) [x_1, ..., x_(p+2)] (. - t)_+^p.
Rational by_divided_difference(const Vector& x, const Rational& t) {
  Rational sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] <= t) continue;
    Rational term = x.back() - x.front();
    for (std::size_t power = 2; power < x.size(); ++power) term *= x[i] - t;
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (k != i) term /= x[i] - x[k];
    }
    sum += term;
  }
  return sum;
}

Rational value(const Vector& x, const Rational& t) {
  if (t < x.front() || t >= x.back()) return 0;
  std::size_t piece = 0;
  while (t >= x[piece + 1]) ++piece;
  return bspline_piece_value<Rational>(x, piece, t);
}

TEST(Bspline, ValuesByHand) {
  const Vector cubic{0, 1, 2, 3, 4};
  EXPECT_EQ(value(cubic, 1), ratio(1, 6));
  EXPECT_EQ(value(cubic, 2), ratio(2, 3));
  EXPECT_EQ(value(cubic, ratio(1, 2)), ratio(1, 48));
  EXPECT_EQ(bspline_piece_value<Rational>(cubic, 0, 2), ratio(8, 6)) << "t^3/6 continued";
  EXPECT_EQ(value(Vector{0, 1, 3}, 2), ratio(1, 2)) << "a hat";
}

RC_GTEST_PROP(Bspline, Law1ValuesAreTheDefinition, ()) {
  const Vector x = any_lines(*rc::gen::inRange<std::size_t>(3, 9));
  const Rational t = x.back() * ratio(*rc::gen::inRange(-1, 40), 37);
  RC_ASSERT(value(x, t) == by_divided_difference(x, t));
}

// (0,1,2,3,4) with 3/2: N = 1/2 N(0,1,3/2,2,3) + 5/6 N(1,3/2,2,3,4).
TEST(Bspline, InsertionByHand) {
  const Vector lines{0, 1, ratio(3, 2), 2, 3, 4};
  EXPECT_EQ(refined_coefficients<Rational>(Ranks{0, 1, 3, 4, 5}, lines), (Vector{ratio(1, 2), ratio(5, 6)}));
  EXPECT_EQ(refined_coefficients<Rational>(Ranks{0, 1, 2, 3, 4}, lines), (Vector{1}));
}

RC_GTEST_PROP(Bspline, Law2KnotInsertion, ()) {
  const auto length = *rc::gen::inRange<std::size_t>(3, 8);
  const Vector lines = any_lines(length + *rc::gen::inRange<std::size_t>(0, 5));
  const Ranks ranks = any_ranks(lines.size(), length);
  const Vector coefficients = refined_coefficients<Rational>(ranks, lines);
  RC_ASSERT(coefficients.size() == static_cast<std::size_t>(ranks.back() - ranks.front()) + 2 - length);
  const Rational t = lines.back() * ratio(*rc::gen::inRange(0, 97), 97);
  Rational sum = 0;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    RC_ASSERT(coefficients[i] > 0);
    const auto first = lines.begin() + ranks.front() + static_cast<std::ptrdiff_t>(i);
    sum += coefficients[i] * value({first, first + static_cast<std::ptrdiff_t>(length)}, t);
  }
  RC_ASSERT(sum == value(at_lines(lines, ranks), t));
}

RC_GTEST_PROP(Bspline, Law3Reduction, ()) {
  const auto length = *rc::gen::inRange<std::size_t>(3, 8);
  const Vector lines = any_lines(length + *rc::gen::inRange<std::size_t>(0, 5));
  const Ranks ranks = any_ranks(lines.size(), length);
  std::vector<Residue> residues;
  for (const Rational& line : lines) residues.push_back(*residue_of(line));
  const auto exact = refined_coefficients<Rational>(ranks, lines);
  const auto reduced = refined_coefficients<Residue>(ranks, residues);
  RC_ASSERT(exact.size() == reduced.size());
  for (std::size_t i = 0; i < exact.size(); ++i) RC_ASSERT(residue_of(exact[i]) == reduced[i]);
}

}  // namespace
}  // namespace asts
