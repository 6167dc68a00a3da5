#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "lib/exact/cosine_field.hpp"
#include "lib/exact/rational.hpp"

namespace asts {

/// Eq. (6.1): every entry of one vector that lies in the closed span of the other is an entry of the other, and vice
/// versa. Symmetric; vectors with disjoint closed spans overlap. REQUIRES: both strictly increasing and not empty.
bool vectors_overlap(std::span<const Rational> x, std::span<const Rational> x_tilde);

/// The dual functionals of Proposition 6.1 for one odd degree p, applied to B-splines, exactly.
///
/// Notation. X = (x_1 < ... < x_(p+2)) and X~ are local index vectors; N_X~ is the B-spline with knots X~, normalised
/// to be part of a partition of unity; y_0 < ... < y_(p+1) are the extrema of the Chebyshev polynomial T_(p+1); G(u) =
/// integral of B*_(p+1) from -1 to u, 0 left of -1 and 1 right of 1; u(x) = (2x - x_1 - x_(p+2))/(x_(p+2) - x_1). The
/// paper defines lambda_X(f) = integral over [x_1, x_(p+2)] of f D^(p+1)(G(u(x)) (x - x_2)...(x - x_(p+1))/p!).
///
/// Closed form. With g(x) = G(u(x)) (x - x_2)...(x - x_(p+1)) on the whole line,
///
///     lambda_X(N_X~) = (x~_(p+2) - x~_1) [x~_1, ..., x~_(p+2)] g          ([...] is the divided difference)
///                    = sum over k of  g(x~_k) (x~_(p+2) - x~_1) / product over i != k of (x~_k - x~_i).
///
/// Proof. B* is a spline of degree p with simple knots, so G has p continuous derivatives and a piecewise continuous
/// (p+1)-st one, and so has g. Left of x_1, g = 0; right of x_(p+2), g is a polynomial of degree p; hence D^(p+1) g
/// vanishes outside [x_1, x_(p+2)] and the paper's integral may run over the whole line. Peano's form of a divided
/// difference of such a g is [X~]g = integral of (D^(p+1) g / (p+1)!) M with M = (p+1) N_X~ / (x~_(p+2) - x~_1), the
/// B-spline of integral 1. So the integral of N_X~ D^(p+1) g is p! (x~_(p+2) - x~_1) [X~]g, and the p! cancels the
/// paper's 1/p!.
///
/// G. By definition B*(t) = (p+1) (-1)^(p+1) sum_j w_j (t - y_j)_+^p, w_j = 1/product over i != j of (y_j - y_i), so
/// for odd p G(u) = sum_j w_j (u - y_j)_+^(p+1). The y_j are the zeros of (x^2-1) U_p(x), where 2^p is the leading
/// coefficient of U_p = T'_(p+1)/(p+1); the derivative of 2^-p (x^2-1) U_p at y_j is 2^-p (p+1) T_(p+1)(y_j) by the
/// differential equation of T_(p+1), and twice that at y_j = +-1, and T_(p+1)(y_j) = (-1)^(p+1-j). So
/// w_j = (-1)^(p+1-j) 2^p/(p+1), halved for the first and the last j: rational.
///
/// Only entries x~_k strictly inside (x_1, x_(p+2)) that are not entries of X meet G strictly between 0 and 1 (entries
/// of X make a factor of g vanish), so no irrational number arises when X and X~ overlap.
///
/// Laws (each has a test that names it):
///  1. Proposition 6.1: vectors_overlap(X, X~) implies lambda_X(N_X~) = (X == X~ ? 1 : 0).
///  2. affine invariance: lambda_(aX+b)(N_(aX~+b)) = lambda_X(N_X~) for a > 0 (both sides of the closed form have
///  degree
///     0 in lengths) and, as B* is even, for a < 0, where the vectors are reversed.
///  3. support: 0 when [x_1, x_(p+2)] and [x~_1, x~_(p+2)] have no common interior.
///  4. definition: equals the integral of the definition, computed piece by piece.
///  5. G is increasing, G(u) + G(-u) = 1.
///
/// Values are kept: G(u) by u, and lambda by the pair of vectors up to a common positive affine map (law 2). Keep one
/// object a degree and a thread; it is not safe to share between threads.
class DualFunctional {
 public:
  /// Throws InputError unless the degree is odd and at least 1.
  explicit DualFunctional(int degree);

  int degree() const { return degree_; }
  /// The field of N = p+1, which all values belong to.
  const CosineFieldPointer& field() const { return field_; }

  /// lambda_X(N_X~). Throws InputError unless both vectors are strictly increasing and have p+2 entries.
  /// Cost: O(p) comparisons when law 3 applies, else O(p) rational operations and a look-up; the first time for a pair
  /// O(p^2) integer operations and perfect_antiderivative for each entry of X~ inside X's span that is not in X.
  FieldElement lambda(std::span<const Rational> x, std::span<const Rational> x_tilde);

  /// G(u). Cost: the first time for u, O(p) powers of exponent p+1 in the field.
  FieldElement perfect_antiderivative(const Rational& u);

  /// How many pairs of vectors, counted up to positive affine maps, have their value kept. Bounded: it starts over.
  std::size_t kept() const { return values_.size(); }

  /// y_j, j = 0..p+1.
  const std::vector<FieldElement>& nodes();

 private:
  FieldElement evaluate(std::span<const Integer> x, std::span<const Integer> x_tilde);

  int degree_;
  CosineFieldPointer field_;
  std::vector<FieldElement> nodes_;
  std::map<Rational, FieldElement> antiderivatives_;
  std::map<std::vector<Integer>, FieldElement> values_;
};

}  // namespace asts
