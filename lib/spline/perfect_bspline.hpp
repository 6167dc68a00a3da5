#pragma once

#include <span>
#include <vector>

#include "lib/exact/cosine_field.hpp"
#include "lib/exact/rational.hpp"

namespace asts {

/// A polynomial h -> c_0 + c_1 h + ... in the distance h from the left end of a piece.
using LocalPolynomial = std::vector<FieldElement>;

/// The perfect B-spline of Proposition 6.1, as printed:
///
///     B*_(p+1)(x) = (p+1) (-1)^(p+1) [y_0, ..., y_(p+1)] (x - .)_+^p,   y_j = cos((p-j+1) pi/(p+1)),
///
/// the divided difference being sum over j of w_j (x - y_j)_+^p with w_j = 1/product over i != j of (y_j - y_i). The
/// w_j are rational (DualFunctional has the proof): (-1)^(p+1-j) 2^p/(p+1), halved for the first and the last j.
/// Any degree p >= 1, even or odd. Pieces are those between neighbouring y_j: 0, ..., p.
///
/// Laws (each has a test that names it):
///  1. w_j times the product of the y_j - y_i is 1.
///  2. pieces fit together: p-1 derivatives of B* are continuous; B* ends in 0 at 1.
///  3. antiderivative: G(-1) = 0, G' = B*, and G is the function of DualFunctional.
struct PerfectBspline {
  int degree;
  CosineFieldPointer field;
  std::vector<FieldElement> knots;  ///< y_0 < ... < y_(p+1)
  std::vector<Rational> weights;    ///< w_0, ..., w_(p+1)
  Rational factor;                  ///< (p+1) (-1)^(p+1)

  int pieces() const { return degree + 1; }
};

/// Throws InputError unless the degree is at least 1.
PerfectBspline perfect_bspline(int degree);

/// B* on piece j. Cost: O(p^2) operations in the field.
LocalPolynomial perfect_piece(const PerfectBspline& spline, int piece);

/// G(u) = integral of B* from -1 to u, on each piece. Cost: O(p^3) operations in the field.
std::vector<LocalPolynomial> perfect_antiderivative(const PerfectBspline& spline);

/// The Bernstein coefficients of a polynomial over [0, length]: it lies between the least and the greatest of them. If
/// none is negative and one is positive, it is positive inside.
std::vector<FieldElement> bernstein_coefficients(const LocalPolynomial& polynomial, const FieldElement& length);

/// D^(p+1)(G_X phi_X) up to the positive factor of the substitution: the density of lambda_X, as a function of
/// u = (2x - x_1 - x_(p+2))/(x_(p+2) - x_1) in [-1, 1], on each piece. REQUIRES: X increases strictly, p+2 entries.
std::vector<LocalPolynomial> dual_density(const PerfectBspline& spline, std::span<const Rational> x);

bool is_zero(const LocalPolynomial& polynomial);
/// The polynomial's value at h.
FieldElement value_at(const LocalPolynomial& polynomial, const FieldElement& h);

}  // namespace asts
