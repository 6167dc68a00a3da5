#include "tests/reference/independence_claims.hpp"

#include <algorithm>
#include <map>

#include "tests/reference/dual.hpp"
#include "tests/reference/suitability.hpp"

namespace asts::reference {

namespace {

using Vector = std::vector<Rational>;

Rational value_at(const RationalPolynomial& polynomial, const Rational& x) {
  Rational result = 0;
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) result = result * x + *c;
  return result;
}

/// The antiderivative of a * b from lower to upper.
Rational integral(const RationalPolynomial& a, const RationalPolynomial& b, const Rational& lower,
                  const Rational& upper) {
  RationalPolynomial primitive(a.size() + b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) primitive[i + j + 1] += a[i] * b[j] / (i + j + 1);
  return value_at(primitive, upper) - value_at(primitive, lower);
}

/// The integral of N_X N_X~ over the line.
Rational product_integral(const Vector& x, const Vector& other) {
  const std::vector<RationalPolynomial> first = b_spline(x), second = b_spline(other);
  Rational sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t j = 0; j < second.size(); ++j) {
      const Rational lower = std::max(x[i], other[j]), upper = std::min(x[i + 1], other[j + 1]);
      if (lower < upper) sum += integral(first[i], second[j], lower, upper);
    }
  return sum;
}

std::size_t rank_by_elimination(std::vector<Vector> rows) {
  std::size_t rank = 0;
  for (std::size_t column = 0; rank < rows.size() && column < rows.front().size(); ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const Vector& row) { return row[column] != 0; });
    if (pivot == rows.end()) continue;
    std::swap(*pivot, rows[rank]);
    for (std::size_t r = rank + 1; r < rows.size(); ++r) {
      const Rational factor = rows[r][column] / rows[rank][column];
      for (std::size_t c = column; factor != 0 && c < rows[r].size(); ++c) rows[r][c] -= factor * rows[rank][c];
    }
    ++rank;
  }
  return rank;
}

}  // namespace

namespace {

/// The integrals of B_v B_w over R^3.
std::vector<Vector> gram_matrix(const std::vector<ActiveNode<Rational>>& splines) {
  std::map<std::pair<Vector, Vector>, Rational> known;
  const auto along = [&](const Vector& x, const Vector& other) {
    const auto found = known.find({x, other});
    return found != known.end() ? found->second : known[{x, other}] = product_integral(x, other);
  };
  std::vector<Vector> gram(splines.size(), Vector(splines.size()));
  for (std::size_t v = 0; v < splines.size(); ++v)
    for (std::size_t w = 0; w < splines.size(); ++w) {
      gram[v][w] = 1;
      for (std::size_t a = 0; a < dimension; ++a)
        if (gram[v][w] != 0) gram[v][w] *= along(splines[v].vectors[a], splines[w].vectors[a]);
    }
  return gram;
}

}  // namespace

std::size_t rank_of_blending_functions(const std::vector<ActiveNode<Rational>>& splines) {
  return splines.empty() ? 0 : rank_by_elimination(gram_matrix(splines));
}

Rational squared_norm(const std::vector<ActiveNode<Rational>>& splines, const Vector& coefficients) {
  const std::vector<Vector> gram = gram_matrix(splines);
  Rational sum = 0;
  for (std::size_t v = 0; v < splines.size(); ++v)
    for (std::size_t w = 0; w < splines.size(); ++w) sum += coefficients[v] * gram[v][w] * coefficients[w];
  return sum;
}

bool overlapping_vectors_are_dual(const std::vector<Vector>& vectors) {
  for (const Vector& x : vectors)
    for (const Vector& other : vectors) {
      if (!overlap(x, other)) continue;
      const Number& value = lambda_remembered(x, other);
      const bool delta = x == other ? is_rational(value) && value[0] == 1 : is_zero(value);
      if (!delta) return false;
    }
  return true;
}

namespace {

void drop_zeros(NumberPolynomial& polynomial) {
  while (!polynomial.empty() && is_zero(polynomial.back())) polynomial.pop_back();
}

/// polynomial / (x - zero), for a zero of it.
NumberPolynomial without_zero(const CosineField& field, const NumberPolynomial& polynomial, const Number& zero) {
  NumberPolynomial result(polynomial.size() - 1);
  Number carried = field.rational(0);
  for (std::size_t i = polynomial.size() - 1; i > 0; --i) {
    carried = field.add(polynomial[i], field.multiply(carried, zero));
    result[i - 1] = carried;
  }
  return result;
}

/// The negative remainder of a division.
NumberPolynomial negative_remainder(const CosineField& field, NumberPolynomial a, const NumberPolynomial& b) {
  const Number inverse = field.inverse(b.back());
  while (a.size() >= b.size()) {
    const Number factor = field.multiply(a.back(), inverse);
    const std::size_t shift = a.size() - b.size();
    for (std::size_t i = 0; i < b.size(); ++i)
      a[i + shift] = field.subtract(a[i + shift], field.multiply(factor, b[i]));
    drop_zeros(a);
  }
  for (Number& c : a) c = field.scale(-1, c);
  return a;
}

int sign_changes(const CosineField& field, const std::vector<NumberPolynomial>& chain, const Number& x) {
  int changes = 0, last = 0;
  for (const NumberPolynomial& polynomial : chain) {
    const int sign = field.sign(reference::value_at(field, polynomial, x));
    if (sign == 0) continue;
    changes += last != 0 && sign != last;
    last = sign;
  }
  return changes;
}

/// Sturm: the number of different zeros between a and b, neither of which is one.
int zeros_between(const CosineField& field, const NumberPolynomial& polynomial, const Number& a, const Number& b) {
  NumberPolynomial derivative;
  for (std::size_t i = 1; i < polynomial.size(); ++i) derivative.push_back(field.scale(i, polynomial[i]));
  std::vector<NumberPolynomial> chain{polynomial};
  while (!derivative.empty()) {
    chain.push_back(derivative);
    derivative = negative_remainder(field, chain[chain.size() - 2], chain.back());
  }
  return sign_changes(field, chain, a) - sign_changes(field, chain, b);
}

bool positive_between(const CosineField& field, NumberPolynomial polynomial, const Number& a, const Number& b) {
  drop_zeros(polynomial);
  if (polynomial.empty()) return false;
  const Number middle = field.scale(Rational(1) / 2, field.add(a, b));
  if (field.sign(value_at(field, polynomial, middle)) <= 0) return false;
  for (const Number& end : {a, b})
    while (is_zero(value_at(field, polynomial, end))) polynomial = without_zero(field, polynomial, end);
  return zeros_between(field, polynomial, a, b) == 0;
}

}  // namespace

bool perfect_spline_rises(int degree) {
  const PerfectSpline& spline = perfect_spline(degree);
  const CosineField& field = spline.field;
  const Number last = value_at(field, spline.antiderivative.back(), spline.knots.back());
  if (!is_zero(field.subtract(last, field.rational(1)))) return false;
  for (std::size_t j = 0; j < spline.pieces.size(); ++j)
    if (!perfect_piece_is_positive(degree, j)) return false;
  return true;
}

bool perfect_piece_is_positive(int degree, std::size_t piece) {
  const PerfectSpline& spline = perfect_spline(degree);
  return positive_between(spline.field, spline.pieces[piece], spline.knots[piece], spline.knots[piece + 1]);
}

bool density_vanishes(const Vector& x, std::size_t piece) {
  const std::size_t p = x.size() - 2;
  const PerfectSpline& spline = perfect_spline(static_cast<int>(p));
  const CosineField& field = spline.field;
  NumberPolynomial phi{field.rational(1)};  // in the variable of G, without the factor
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    const Rational u = (2 * x[i] - x.front() - x.back()) / (x.back() - x.front());
    NumberPolynomial next(phi.size() + 1, field.rational(0));
    for (std::size_t k = 0; k < phi.size(); ++k) {
      next[k + 1] = field.add(next[k + 1], phi[k]);
      next[k] = field.subtract(next[k], field.scale(u, phi[k]));
    }
    phi = next;
  }
  const NumberPolynomial& g = spline.antiderivative[piece];
  for (std::size_t power = p + 1; power < g.size() + phi.size() - 1; ++power) {  // D^{p+1} kills the lower ones
    Number sum = field.rational(0);
    for (std::size_t i = 0; i < g.size(); ++i)
      if (i <= power && power - i < phi.size()) sum = field.add(sum, field.multiply(g[i], phi[power - i]));
    if (!is_zero(sum)) return false;
  }
  return true;
}

bool functional_fills_support(const Vector& x) {
  for (std::size_t piece = 0; piece + 1 < x.size(); ++piece)
    if (density_vanishes(x, piece)) return false;
  return true;
}

}  // namespace asts::reference
