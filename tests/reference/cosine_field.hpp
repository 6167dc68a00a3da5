#pragma once

#include "tests/reference/mesh.hpp"

namespace asts::reference {

/// A polynomial with rational coefficients, constant term first, without a leading zero; the zero polynomial is empty.
using RationalPolynomial = std::vector<Rational>;

/// Quotient of an exact division of polynomials. Throws std::logic_error when there is a remainder.
RationalPolynomial divide_exactly(RationalPolynomial dividend, const RationalPolynomial& divisor);

/// The minimal polynomial of 2 cos(2 pi / n), monic: with V_k(2 cos t) = 2 cos(k t) (Chebyshev),
/// V_{s+1} - V_{s-1} = product over d | n of these for n = 2s, and V_{s+1} - V_s likewise for n = 2s + 1.
RationalPolynomial minimal_polynomial(int n);

/// An element of Q(g): coefficients of 1, g, g^2, ..., as many as the field's degree.
using Number = std::vector<Rational>;

/// The real field Q(g) with g = 2 cos(pi/N), N >= 2, with an isolating interval of g among the real roots of its
/// minimal polynomial. All operations are exact.
class CosineField {
 public:
  explicit CosineField(int n);
  /// The field for N, made once a thread.
  static const CosineField& get(int n);

  int n() const { return n_; }
  std::size_t degree() const { return minimal_.size() - 1; }
  const RationalPolynomial& minimal() const { return minimal_; }

  Number rational(const Rational& value) const;
  /// 2 cos(k pi / N) = V_k(g).
  Number twice_cosine(int k) const;
  Number add(const Number& a, const Number& b) const;
  Number subtract(const Number& a, const Number& b) const;
  Number multiply(const Number& a, const Number& b) const;
  Number scale(const Rational& factor, Number a) const;
  /// REQUIRES: a is not zero (throws std::logic_error).
  Number inverse(const Number& a) const;
  /// -1, 0, 1. Zero is decided exactly: the powers of g below the degree are independent over Q.
  int sign(const Number& a) const;
  /// Rational bounds lower <= a <= upper, closer than 2^-bits times the size of the coefficients.
  std::array<Rational, 2> enclosure(const Number& a, int bits) const;
  /// The same number as an element of `larger`, whose N is a multiple of this one's: g = 2 cos((N'/N) pi/N').
  Number embed(const Number& a, const CosineField& larger) const;

 private:
  std::array<Rational, 2> root_interval(int bits) const;

  int n_;
  RationalPolynomial minimal_;
  std::array<Rational, 2> isolated_;  ///< g lies in it, no other root does; at most 2^-64 long
};

bool is_zero(const Number& a);
bool is_rational(const Number& a);

}  // namespace asts::reference
