#include <fmt/format.h>

#include "lib/spline/perfect_bspline.hpp"
#include "reports/paper/paper.hpp"
#include "reports/paper/text.hpp"

namespace asts {

namespace {

/// B*_(p+1) for p + 1 = 4, 6, 10.
constexpr std::array kDegrees{3, 5, 9};
constexpr int kSamples = 200;  ///< steps from -1 to 1
constexpr int kDigits = 9;

/// B* and its antiderivative, piece by piece.
struct Curves {
  PerfectBspline spline;
  std::vector<LocalPolynomial> density;
  std::vector<LocalPolynomial> antiderivative;

  explicit Curves(int degree) : spline(perfect_bspline(degree)), antiderivative(perfect_antiderivative(spline)) {
    for (int piece = 0; piece < spline.pieces(); ++piece) density.push_back(perfect_piece(spline, piece));
  }

  FieldElement value(const std::vector<LocalPolynomial>& pieces, const Rational& u) const {
    std::size_t piece = 0;
    while (piece + 1 < pieces.size() && spline.knots[piece + 1] <= u) ++piece;
    return value_at(pieces[piece], FieldElement(spline.field, u) - spline.knots[piece]);
  }
};

std::string data_of(const std::vector<Curves>& curves) {
  std::string text = fmt::format(
      "# Proposition 6.1: u, then B* and its antiderivative from -1 for p + 1 = 4, 6, 10;\n"
      "# exact values rounded down to {} significant digits.\n",
      kDigits);
  for (int step = 0; step <= kSamples; ++step) {
    const Rational u = Rational(2 * step, kSamples) - 1;
    text += decimal_text(u, kDigits);
    for (const Curves& one : curves) {
      for (const auto* pieces : {&one.density, &one.antiderivative}) {
        text += " " + decimal_text(one.value(*pieces, u), kDigits);
      }
    }
    text += "\n";
  }
  return text;
}

std::vector<std::string> row_of(const Curves& curves) {
  const FieldElement middle = curves.value(curves.density, 0);
  std::string knots;
  for (const FieldElement& knot : curves.spline.knots) knots += (knots.empty() ? "" : ", ") + decimal_text(knot, 4);
  return {fmt::format("{}", curves.spline.degree + 1), knots,
          middle.is_rational() ? to_string(middle.to_rational()) : decimal_text(middle, kDigits),
          to_string(curves.value(curves.antiderivative, 0).to_rational()),
          to_string(curves.value(curves.antiderivative, 1).to_rational())};
}

}  // namespace

void add_perfect_bsplines(Paper& paper) {
  std::vector<Curves> curves;
  std::vector<std::vector<std::string>> rows{
      {"p + 1", "y_0, ..., y_(p+1), rounded down", "B* at 0", "integral from -1 to 0", "integral from -1 to 1"}};
  for (const int degree : kDegrees) {
    curves.emplace_back(degree);
    rows.push_back(row_of(curves.back()));
  }
  paper.files.push_back({"perfect-bsplines.dat", data_of(curves)});
  paper.tables["perfect-bsplines"] = markdown_table(rows);
}

}  // namespace asts
