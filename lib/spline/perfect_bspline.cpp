#include "lib/spline/perfect_bspline.hpp"

#include <algorithm>
#include <memory>

#include "lib/exact/errors.hpp"
#include "lib/mesh/axis.hpp"

namespace asts {
namespace {

/// n over k.
Rational binomial(int n, int k) {
  Rational result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

LocalPolynomial product(const LocalPolynomial& a, const LocalPolynomial& b) {
  LocalPolynomial result(a.size() + b.size() - 1, FieldElement(a.front().field(), Rational(0)));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  return result;
}

LocalPolynomial derivative(const LocalPolynomial& polynomial, int times) {
  LocalPolynomial result = polynomial;
  for (int round = 0; round < times; ++round) {
    for (std::size_t i = 1; i < result.size(); ++i) result[i - 1] = result[i] * Rational(i);
    result.pop_back();
  }
  return result;
}

/// p! phi_X on the piece that begins at y: the product of the h + y - u(x_i) over the inner entries.
LocalPolynomial inner_product(const FieldElement& y, std::span<const Rational> x) {
  const FieldElement one(y.field(), Rational(1));
  LocalPolynomial result{one};
  for (const Rational& entry : x.subspan(1, x.size() - 2)) {
    const Rational u = (2 * entry - x.front() - x.back()) / (x.back() - x.front());
    result = product(result, {y - FieldElement(y.field(), u), one});
  }
  return result;
}

}  // namespace

PerfectBspline perfect_bspline(int degree) {
  require(degree >= 1, "the perfect B-spline has a degree of at least 1");
  PerfectBspline spline{degree, std::make_shared<const CosineField>(degree + 1), {}, {}, {}};
  for (int j = 0; j <= degree + 1; ++j) {
    spline.knots.push_back(cosine(spline.field, degree - j + 1, degree + 1));
    Rational weight(Integer(1) << degree, Integer(degree + 1));
    if (j == 0 || j == degree + 1) weight /= 2;
    spline.weights.push_back((degree + 1 - j) % 2 == 0 ? weight : -weight);
  }
  spline.factor = degree % 2 == 1 ? degree + 1 : -(degree + 1);
  return spline;
}

LocalPolynomial perfect_piece(const PerfectBspline& spline, int piece) {
  const int p = spline.degree;
  LocalPolynomial result(at(p) + 1, FieldElement(spline.field, Rational(0)));
  for (int i = 0; i <= piece; ++i) {  // (y_j + h - y_i)^p, expanded in h
    const FieldElement distance = spline.knots[at(piece)] - spline.knots[at(i)];
    FieldElement term(spline.field, spline.weights[at(i)] * spline.factor);
    for (int k = p; k >= 0; --k) {
      result[at(k)] += term * binomial(p, k);
      term *= distance;
    }
  }
  return result;
}

std::vector<LocalPolynomial> perfect_antiderivative(const PerfectBspline& spline) {
  std::vector<LocalPolynomial> result;
  FieldElement reached(spline.field, Rational(0));
  for (int j = 0; j < spline.pieces(); ++j) {
    LocalPolynomial primitive{reached};
    for (const FieldElement& c : perfect_piece(spline, j)) primitive.push_back(c / Rational(primitive.size()));
    reached = value_at(primitive, spline.knots[at(j) + 1] - spline.knots[at(j)]);
    result.push_back(std::move(primitive));
  }
  return result;
}

std::vector<FieldElement> bernstein_coefficients(const LocalPolynomial& polynomial, const FieldElement& length) {
  const int n = static_cast<int>(polynomial.size()) - 1;
  std::vector<FieldElement> scaled;  // c_k length^k / (n over k)
  FieldElement power(length.field(), Rational(1));
  for (int k = 0; k <= n; ++k) {
    scaled.push_back(polynomial[at(k)] * power / binomial(n, k));
    power *= length;
  }
  std::vector<FieldElement> result;
  for (int i = 0; i <= n; ++i) {
    result.emplace_back(length.field(), Rational(0));
    for (int k = 0; k <= i; ++k) result.back() += scaled[at(k)] * binomial(i, k);
  }
  return result;
}

std::vector<LocalPolynomial> dual_density(const PerfectBspline& spline, std::span<const Rational> x) {
  require(x.size() == at(spline.degree) + 2, "an index vector of degree p has p+2 entries");
  const std::vector<LocalPolynomial> g = perfect_antiderivative(spline);
  std::vector<LocalPolynomial> result;
  for (int j = 0; j < spline.pieces(); ++j) {
    const LocalPolynomial phi = inner_product(spline.knots[at(j)], x);
    result.push_back(derivative(product(g[at(j)], phi), spline.degree + 1));
  }
  return result;
}

bool is_zero(const LocalPolynomial& polynomial) {
  return std::all_of(polynomial.begin(), polynomial.end(), [](const FieldElement& c) { return c.is_zero(); });
}

FieldElement value_at(const LocalPolynomial& polynomial, const FieldElement& h) {
  FieldElement result(h.field(), Rational(0));
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) result = result * h + *c;
  return result;
}

}  // namespace asts
