/// The closed form of lib/spline/dual_functional.hpp against the integral that defines lambda_X, computed exactly,
/// piece by piece, with polynomials over the field: products, derivatives, antiderivatives; no divided difference.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "lib/spline/dual_functional.hpp"

namespace asts {
namespace {

using Vector = std::vector<Rational>;
/// Coefficients of 1, x, x^2, ...
using Polynomial = std::vector<FieldElement>;

struct Integrator {
  explicit Integrator(int p) : functional(p) {}

  FieldElement number(const Rational& value) const { return {functional.field(), value}; }

  Polynomial linear(const FieldElement& at_zero, const Rational& slope) const { return {at_zero, number(slope)}; }

  Polynomial product(const Polynomial& a, const Polynomial& b) const {
    Polynomial result(a.size() + b.size() - 1, number(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
    }
    return result;
  }

  Polynomial sum(Polynomial a, const Polynomial& b) const {
    if (a.size() < b.size()) a.resize(b.size(), number(0));
    for (std::size_t i = 0; i < b.size(); ++i) a[i] += b[i];
    return a;
  }

  Polynomial derivative(Polynomial a) const {
    for (std::size_t i = 1; i < a.size(); ++i) a[i - 1] = a[i] * Rational(i);
    a.back() = number(0);
    return a;
  }

  FieldElement integral(const Polynomial& a, const FieldElement& from, const FieldElement& to) const {
    FieldElement result = number(0);
    for (unsigned i = 0; i < a.size(); ++i) {
      result += a[i] * (power(to, i + 1) - power(from, i + 1)) / Rational(i + 1);
    }
    return result;
  }

  /// The polynomial that the B-spline with knots[first..first+degree+1] is on the knot span `piece` (Cox-de Boor).
  Polynomial b_spline(const Vector& knots, std::size_t first, std::size_t degree, std::size_t piece) const {
    if (degree == 0) return {number(first == piece ? 1 : 0)};
    const Rational left = knots[first + degree] - knots[first];
    const Rational right = knots[first + degree + 1] - knots[first + 1];
    const Polynomial rising = linear(number(-knots[first] / left), 1 / left);
    const Polynomial falling = linear(number(knots[first + degree + 1] / right), -1 / right);
    return sum(product(rising, b_spline(knots, first, degree - 1, piece)),
               product(falling, b_spline(knots, first + 1, degree - 1, piece)));
  }

  /// phi_X times p! times G_X where `nodes_left` of the mapped nodes y_j lie on the left.
  Polynomial weighted_product(const Vector& x, std::size_t nodes_left) {
    const Rational length = x.back() - x.front();
    Polynomial g{number(0)};
    for (std::size_t j = 0; j < nodes_left; ++j) {
      // (u(x) - y_j)^(p+1) / product over i != j of (y_j - y_i); test WeightsAreTheReciprocalProducts checks the
      // factor.
      Rational weight = Rational(Integer(1) << functional.degree()) / (functional.degree() + 1);
      if (j == 0) weight /= 2;
      if (j % 2 == 1) weight = -weight;
      const Polynomial distance = linear(number((-x.front() - x.back()) / length) - functional.nodes()[j], 2 / length);
      Polynomial term{number(weight)};
      for (int i = 0; i <= functional.degree(); ++i) term = product(term, distance);
      g = sum(g, term);
    }
    for (std::size_t i = 1; i + 1 < x.size(); ++i) g = product(g, linear(number(-x[i]), 1));
    return g;
  }

  /// Breakpoints of the integrand in [x_1, x_(p+2)]: the mapped nodes and the entries of X~.
  std::set<FieldElement> breakpoints(const Vector& x, const Vector& x_tilde) {
    std::set<FieldElement> result;
    for (const FieldElement& y : functional.nodes()) {
      result.insert((y * (x.back() - x.front()) + number(x.front() + x.back())) / Rational(2));
    }
    for (const Rational& entry : x_tilde) {
      if (entry > x.front() && entry < x.back()) result.insert(number(entry));
    }
    return result;
  }

  FieldElement lambda_by_definition(const Vector& x, const Vector& x_tilde) {
    const std::set<FieldElement> breaks = breakpoints(x, x_tilde);
    FieldElement result = number(0);
    std::size_t nodes_left = 0;
    for (auto from = breaks.begin(), to = std::next(from); to != breaks.end(); ++from, ++to) {
      const FieldElement u = (*from * Rational(2) - number(x.front() + x.back())) / (x.back() - x.front());
      while (functional.nodes()[nodes_left] <= u) ++nodes_left;
      const auto after = std::find_if(x_tilde.begin(), x_tilde.end(), [&](const Rational& t) { return *from < t; });
      if (after == x_tilde.begin() || after == x_tilde.end()) continue;  // outside the support of N_X~
      const auto piece = static_cast<std::size_t>(after - x_tilde.begin()) - 1;
      Polynomial density = weighted_product(x, nodes_left);
      for (int i = 0; i <= functional.degree(); ++i) density = derivative(density);
      const auto p = static_cast<std::size_t>(functional.degree());
      result += integral(product(density, b_spline(x_tilde, 0, p, piece)), *from, *to);
    }
    for (int i = 2; i <= functional.degree(); ++i) result /= Rational(i);  // phi's 1/p!
    return result;
  }

  DualFunctional functional;
};

Vector any_vector(int p) {
  Vector x{Rational(*rc::gen::inRange(0, 9)) / 3};
  for (int i = 1; i < p + 2; ++i) x.push_back(x.back() + Rational(*rc::gen::inRange(1, 5)) / 3);
  return x;
}

TEST(DualFunctionalDefinition, TheIntegratorFindsTheHandExample) {
  Integrator linear(1);
  EXPECT_EQ(linear.lambda_by_definition(Vector{0, 1, 2}, Vector{0, Rational(1) / 2, 2}), Rational(5) / 6);
  EXPECT_EQ(linear.lambda_by_definition(Vector{0, 1, 2}, Vector{0, 1, 2}), Rational(1));
}

TEST(DualFunctionalDefinition, Law4FieldsOfDegreeTwoAndFour) {
  for (const int p : {3, 5, 7}) {
    Integrator integrator(p);
    Vector x, x_tilde;
    for (int i = 0; i < p + 2; ++i) {
      x.push_back(i);
      x_tilde.push_back(Rational(2 * i + 1) / 3);
    }
    const FieldElement closed = integrator.functional.lambda(x, x_tilde);
    EXPECT_EQ(closed, integrator.lambda_by_definition(x, x_tilde)) << p;
    EXPECT_FALSE(closed.is_rational()) << "an example that does need the field, p = " << p;
  }
}

RC_GTEST_PROP(DualFunctionalDefinition, Law4EqualsTheDefiningIntegral, ()) {
  const int p = *rc::gen::element(1, 3);
  Integrator integrator(p);
  const Vector x = any_vector(p), x_tilde = any_vector(p);
  RC_ASSERT(integrator.functional.lambda(x, x_tilde) == integrator.lambda_by_definition(x, x_tilde));
}

}  // namespace
}  // namespace asts
