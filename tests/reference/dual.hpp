#pragma once

#include "tests/reference/cosine_field.hpp"
#include "tests/reference/grid.hpp"

namespace asts::reference {

/// A polynomial over Q(g), constant term first.
using NumberPolynomial = std::vector<Number>;

/// Proposition 6.1: the perfect B-spline B* of degree p on the knots y_j = cos((p-j+1) pi/(p+1)), j = 0..p+1, by its
/// formula (p+1) (-1)^(p+1) [y_0, ..., y_{p+1}] (x - .)_+^p, and its antiderivative G with G(-1) = 0. Piece j of either
/// lives on [y_j, y_{j+1}].
struct PerfectSpline {
  const CosineField& field;
  std::vector<Number> knots;
  std::vector<NumberPolynomial> pieces, antiderivative;
};

/// The perfect B-spline of degree p >= 1, made once a thread, over the field with N = p + 1.
const PerfectSpline& perfect_spline(int degree);

/// The polynomial's value at x.
Number value_at(const CosineField& field, const NumberPolynomial& polynomial, const Number& x);

/// The B-spline N_X by Cox and de Boor's recursion, normalised as in a partition of unity: p+1 rational polynomials,
/// piece i on [x_i, x_{i+1}]. REQUIRES: p+2 strictly increasing knots.
std::vector<RationalPolynomial> b_spline(const std::vector<Rational>& knots);

/// Proposition 6.1: lambda_X(N_X~) = integral over [x_1, x_{p+2}] of N_X~ D^{p+1}(G_X phi_X), as the sum of the exact
/// integrals over all pieces between knots of X~ and images of the y_j. In the field with N = p + 1.
/// REQUIRES: both vectors strictly increasing with p+2 entries.
Number lambda(const std::vector<Rational>& x, const std::vector<Rational>& other);

/// The same number, remembered for every pair of vectors up to a common translation and scaling: substituting
/// x = a + b t, b > 0, phi_X gets the factor b^p, D^{p+1} the factor b^-(p+1), dx the factor b; so lambda does not change.
template <class T>
const Number& lambda_remembered(const std::vector<T>& x, const std::vector<T>& other);

/// Definition 6.2: the product of three factors, factor a given in the field with N = degree[a] + 1, in the field with
/// N = lcm(p_1 + 1, p_2 + 1, p_3 + 1).
Number product_of_factors(const std::array<int, dimension>& degree, const std::array<Number, dimension>& factors);

/// The field of that product.
const CosineField& common_field(const std::array<int, dimension>& degree);

}  // namespace asts::reference
