#include <map>
#include <memory>

#include "tests/reference/dual.hpp"

namespace asts::reference {

namespace {

/// (x - y)^exponent.
NumberPolynomial shifted_power(const CosineField& field, const Number& y, int exponent) {
  NumberPolynomial result{field.rational(1)};
  for (int e = 0; e < exponent; ++e) {
    NumberPolynomial next(result.size() + 1, field.rational(0));
    for (std::size_t i = 0; i < result.size(); ++i) {
      next[i + 1] = field.add(next[i + 1], result[i]);
      next[i] = field.subtract(next[i], field.multiply(y, result[i]));
    }
    result = next;
  }
  return result;
}

/// The coefficient of f(y_j) in the divided difference [y_0, ..., y_n] f: 1 / prod over i != j of (y_j - y_i).
Number divided_difference_weight(const CosineField& field, const std::vector<Number>& knots, std::size_t j) {
  Number denominator = field.rational(1);
  for (std::size_t i = 0; i < knots.size(); ++i)
    if (i != j) denominator = field.multiply(denominator, field.subtract(knots[j], knots[i]));
  return field.inverse(denominator);
}

void add_to(const CosineField& field, NumberPolynomial& sum, const Number& factor, const NumberPolynomial& term) {
  if (sum.size() < term.size()) sum.resize(term.size(), field.rational(0));
  for (std::size_t i = 0; i < term.size(); ++i) sum[i] = field.add(sum[i], field.multiply(factor, term[i]));
}

NumberPolynomial antiderivative(const CosineField& field, const NumberPolynomial& polynomial) {
  NumberPolynomial result{field.rational(0)};
  for (std::size_t i = 0; i < polynomial.size(); ++i)
    result.push_back(field.scale(Rational(1) / (i + 1), polynomial[i]));
  return result;
}

/// G on every piece: the antiderivative that continues the previous piece, 0 at y_0 = -1.
void integrate_pieces(PerfectSpline& spline) {
  const CosineField& field = spline.field;
  Number reached = field.rational(0);
  for (std::size_t j = 0; j < spline.pieces.size(); ++j) {
    NumberPolynomial g = antiderivative(field, spline.pieces[j]);
    g[0] = field.add(g[0], field.subtract(reached, value_at(field, g, spline.knots[j])));
    reached = value_at(field, g, spline.knots[j + 1]);
    spline.antiderivative.push_back(g);
  }
}

PerfectSpline make_perfect_spline(int p) {
  PerfectSpline spline{CosineField::get(p + 1), {}, {}, {}};
  const CosineField& field = spline.field;
  for (int j = 0; j <= p + 1; ++j)
    spline.knots.push_back(field.scale(Rational(1) / 2, field.twice_cosine(p - j + 1)));
  const Rational sign = (p + 1) % 2 == 0 ? 1 : -1;
  NumberPolynomial sum;  // on [y_j, y_{j+1}] exactly the terms 0..j of (x - y_i)_+^p are switched on
  for (std::size_t j = 0; j + 1 < spline.knots.size(); ++j) {
    const Number weight = field.scale(sign * (p + 1), divided_difference_weight(field, spline.knots, j));
    add_to(field, sum, weight, shifted_power(field, spline.knots[j], p));
    spline.pieces.push_back(sum);
  }
  integrate_pieces(spline);
  return spline;
}

}  // namespace

Number value_at(const CosineField& field, const NumberPolynomial& polynomial, const Number& x) {
  Number result = field.rational(0);
  const bool rational = is_rational(x);
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c)
    result = field.add(rational ? field.scale(x[0], result) : field.multiply(result, x), *c);
  return result;
}

const PerfectSpline& perfect_spline(int degree) {
  static thread_local std::map<int, std::unique_ptr<PerfectSpline>> known;
  std::unique_ptr<PerfectSpline>& spline = known[degree];
  if (!spline) spline = std::make_unique<PerfectSpline>(make_perfect_spline(degree));
  return *spline;
}

}  // namespace asts::reference
