#pragma once

#include "tests/reference/spline.hpp"

namespace asts::reference {

/// Corollary 6.8, literally another way: functions are linearly independent exactly if their Gram matrix, here of the
/// integrals of B_v B_w over R^3, is regular; and sum of c_v B_v = 0 exactly if the Gram matrix kills c. The integral
/// is the product over the axes of the integrals of N_x(v) N_x(w), piece by piece between their knots. Returns the
/// rank, by elimination over Q. Cost: cubic in the functions.
std::size_t rank_of_blending_functions(const std::vector<ActiveNode<Rational>>& splines);

/// The integral of (sum of c_v B_v)^2 over R^3: 0 exactly if the sum is the zero function. REQUIRES: as many
/// coefficients as splines.
Rational squared_norm(const std::vector<ActiveNode<Rational>>& splines, const std::vector<Rational>& coefficients);

/// Proposition 6.1 on a set of index vectors: does every pair that overlaps in the sense of (6.1) have
/// lambda_X(N_X~) = delta, by the integral of the definition?
bool overlapping_vectors_are_dual(const std::vector<std::vector<Rational>>& vectors);

/// Proposition 6.1 for one degree: G(1) = 1, and B* > 0 between neighbouring y_j, by Sturm's theorem: its piece,
/// divided by its zeros at the ends, has no zero between them.
bool perfect_spline_rises(int degree);

/// The same for one piece alone: B* > 0 between y_j and y_(j+1).
bool perfect_piece_is_positive(int degree, std::size_t piece);

/// Is D^{p+1}(G_X phi_X) zero between the images of y_j and y_(j+1)?
bool density_vanishes(const std::vector<Rational>& x, std::size_t piece);

/// Proposition 6.1 for one index vector: no polynomial piece of D^{p+1}(G_X phi_X) is zero.
bool functional_fills_support(const std::vector<Rational>& x);

}  // namespace asts::reference
