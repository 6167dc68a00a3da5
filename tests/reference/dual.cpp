#include "tests/reference/dual.hpp"

#include <algorithm>
#include <numeric>

namespace asts::reference {

namespace {

/// polynomial * (constant + slope x).
RationalPolynomial times_linear(const RationalPolynomial& polynomial, const Rational& constant, const Rational& slope) {
  RationalPolynomial result(polynomial.empty() ? 0 : polynomial.size() + 1);
  for (std::size_t i = 0; i < polynomial.size(); ++i) {
    result[i] += constant * polynomial[i];
    result[i + 1] += slope * polynomial[i];
  }
  return result;
}

void add_to(RationalPolynomial& sum, const RationalPolynomial& term) {
  if (sum.size() < term.size()) sum.resize(term.size());
  for (std::size_t i = 0; i < term.size(); ++i) sum[i] += term[i];
}

}  // namespace

std::vector<RationalPolynomial> b_spline(const std::vector<Rational>& x) {
  const std::size_t intervals = x.size() - 1;
  std::vector<std::vector<RationalPolynomial>> current(intervals, std::vector<RationalPolynomial>(intervals));
  for (std::size_t i = 0; i < intervals; ++i) current[i][i] = {Rational(1)};
  for (std::size_t k = 1; k < intervals; ++k) {
    std::vector<std::vector<RationalPolynomial>> next(intervals - k, std::vector<RationalPolynomial>(intervals));
    for (std::size_t i = 0; i < next.size(); ++i) {
      const Rational rise = Rational(1) / (x[i + k] - x[i]), fall = Rational(1) / (x[i + k + 1] - x[i + 1]);
      for (std::size_t piece = i; piece <= i + k; ++piece) {
        add_to(next[i][piece], times_linear(current[i][piece], -x[i] * rise, rise));
        add_to(next[i][piece], times_linear(current[i + 1][piece], x[i + k + 1] * fall, -fall));
      }
    }
    current = std::move(next);
  }
  return current[0];
}

namespace {

/// phi_X = (x - x_2) ... (x - x_{p+1}) / p!.
RationalPolynomial phi(const std::vector<Rational>& x) {
  RationalPolynomial result{Rational(1)};
  for (std::size_t i = 1; i + 1 < x.size(); ++i) result = times_linear(result, -x[i] / i, Rational(1) / i);
  return result;
}

NumberPolynomial multiply(const CosineField& field, const NumberPolynomial& a, const RationalPolynomial& b) {
  NumberPolynomial result(a.size() + b.size() - 1, field.rational(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      for (std::size_t c = 0; b[j] != 0 && c < a[i].size(); ++c)
        if (a[i][c] != 0) result[i + j][c] += a[i][c] * b[j];
  return result;
}

/// D^times of the polynomial.
NumberPolynomial derivative(const CosineField& field, const NumberPolynomial& polynomial, std::size_t times) {
  NumberPolynomial result;
  for (std::size_t i = times; i < polynomial.size(); ++i) {
    Rational factor = 1;
    for (std::size_t f = i; f > i - times; --f) factor *= f;
    result.push_back(field.scale(factor, polynomial[i]));
  }
  return result;
}

/// The integral of the polynomial from a to b.
Number integral(const CosineField& field, const NumberPolynomial& polynomial, const Number& a, const Number& b) {
  NumberPolynomial primitive{field.rational(0)};
  for (std::size_t i = 0; i < polynomial.size(); ++i)
    primitive.push_back(field.scale(Rational(1) / (i + 1), polynomial[i]));
  return field.subtract(value_at(field, primitive, b), value_at(field, primitive, a));
}

/// The integral of spline_piece * density over the part of [y_j, y_{j+1}] within [lower, upper].
Number piece_integral(const PerfectSpline& perfect, std::size_t j, const NumberPolynomial& density,
                      const RationalPolynomial& spline_piece, const Rational& lower, const Rational& upper) {
  const CosineField& field = perfect.field;
  Number from = field.rational(lower), to = field.rational(upper);
  if (field.sign(field.subtract(from, perfect.knots[j])) < 0) from = perfect.knots[j];
  if (field.sign(field.subtract(to, perfect.knots[j + 1])) > 0) to = perfect.knots[j + 1];
  if (field.sign(field.subtract(to, from)) <= 0) return field.rational(0);
  return integral(field, multiply(field, density, spline_piece), from, to);
}

/// t = (2x - x_1 - x_{p+2}) / (x_{p+2} - x_1): the argument of G_X, sending [x_1, x_{p+2}] to [-1, 1].
std::vector<Rational> transformed(const std::vector<Rational>& vector, const Rational& first, const Rational& last) {
  std::vector<Rational> result;
  for (const Rational& x : vector) result.push_back((2 * x - first - last) / (last - first));
  return result;
}

}  // namespace

Number lambda(const std::vector<Rational>& x, const std::vector<Rational>& other) {
  const std::size_t p = x.size() - 2;
  const PerfectSpline& perfect = perfect_spline(static_cast<int>(p));
  const CosineField& field = perfect.field;
  // In the variable t, where G_X is G itself; lambda does not change under this substitution (see lambda_remembered).
  const std::vector<Rational> knots = transformed(x, x.front(), x.back());
  const std::vector<Rational> other_knots = transformed(other, x.front(), x.back());
  const std::vector<RationalPolynomial> spline = b_spline(other_knots);
  const RationalPolynomial factor = phi(knots);
  Number sum = field.rational(0);
  for (std::size_t j = 0; j <= p; ++j) {
    const NumberPolynomial density = derivative(field, multiply(field, perfect.antiderivative[j], factor), p + 1);
    for (std::size_t i = 0; i <= p; ++i)
      sum = field.add(sum, piece_integral(perfect, j, density, spline[i], other_knots[i], other_knots[i + 1]));
  }
  return sum;
}

const CosineField& common_field(const std::array<int, dimension>& degree) {
  return CosineField::get(std::lcm(std::lcm(degree[0] + 1, degree[1] + 1), degree[2] + 1));
}

Number product_of_factors(const std::array<int, dimension>& degree, const std::array<Number, dimension>& factors) {
  const CosineField& field = common_field(degree);
  Number result = field.rational(1);
  for (std::size_t a = 0; a < dimension; ++a)
    result = field.multiply(result, CosineField::get(degree[a] + 1).embed(factors[a], field));
  return result;
}

}  // namespace asts::reference
