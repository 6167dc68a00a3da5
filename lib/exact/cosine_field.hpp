#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "lib/exact/rational.hpp"

namespace asts {

/// The real number field Q(g), g = 2 cos(pi/N), N >= 1. It contains cos(k pi/n) for every n that divides N and every
/// integer k, hence the nodes y_j = cos((p-j+1) pi/(p+1)) of Proposition 6.1 where N = p+1.
///
/// Its degree over Q is phi(2N)/2 (1 where N = 1), the degree of the minimal polynomial of g, which is monic with
/// integer coefficients. That polynomial is computed when it is first needed, so that a field of huge N costs nothing
/// while all its elements are rational. Safe to share between threads.
class CosineField {
 public:
  /// Throws InputError unless n >= 1.
  explicit CosineField(int n);

  int n() const { return n_; }
  int degree() const { return degree_; }
  /// The coefficients of 1, x, ..., x^degree.
  const std::vector<Integer>& minimal_polynomial() const;

 private:
  int n_;
  int degree_;
  mutable std::once_flag once_;
  mutable std::vector<Integer> minimal_polynomial_;
};

using CosineFieldPointer = std::shared_ptr<const CosineField>;

/// An element c_0 + c_1 g + ... + c_(d-1) g^(d-1) of a CosineField of degree d: a value, copied and compared like a
/// number. The representation is unique, so zero is recognised exactly, by looking; and a sign that is not zero is
/// certified by a ball (Arb) of growing precision, which ends because the zero test came first.
///
/// Laws (each has a test that names it):
///  1. arithmetic: +, -, * by elements and *, / by rationals satisfy the field's identities; g is a root of
///     minimal_polynomial().
///  2. order: <=> is the order of the real numbers, compatible with + and with * by positive elements.
///  3. values: cosine(k, n) satisfies cos(a)^2 + sin(a)^2 = 1, cos(2a) = 2 cos(a)^2 - 1, and the known closed forms.
///  4. embedding: embed() is a homomorphism of ordered fields that maps cosine(k, n) to cosine(k, n).
///  5. enclosure: lower <= value <= upper, both exact where the value is a decimal of so many digits, and one unit in
///     the last place apart otherwise.
///
/// Operations of two elements throw InputError when their fields differ.
class FieldElement {
 public:
  FieldElement(CosineFieldPointer field, const Rational& value);
  /// The polynomial with these coefficients (constant first, any number of them) at g.
  FieldElement(CosineFieldPointer field, std::vector<Rational> coefficients);

  const CosineFieldPointer& field() const { return field_; }
  /// c_0, c_1, ...: at most degree() of them, the last one not zero; none for 0.
  const std::vector<Rational>& coefficients() const { return coefficients_; }
  bool is_zero() const { return coefficients_.empty(); }
  bool is_rational() const { return coefficients_.size() <= 1; }
  /// Throws InputError unless is_rational().
  Rational to_rational() const;

  FieldElement& operator+=(const FieldElement& other);
  FieldElement& operator-=(const FieldElement& other);
  FieldElement& operator*=(const FieldElement& other);
  FieldElement& operator*=(const Rational& factor);
  /// Throws InputError when the divisor is 0.
  FieldElement& operator/=(const Rational& divisor);

  friend FieldElement operator+(FieldElement a, const FieldElement& b) { return a += b; }
  friend FieldElement operator-(FieldElement a, const FieldElement& b) { return a -= b; }
  friend FieldElement operator*(FieldElement a, const FieldElement& b) { return a *= b; }
  friend FieldElement operator*(FieldElement a, const Rational& b) { return a *= b; }
  friend FieldElement operator/(FieldElement a, const Rational& b) { return a /= b; }
  friend FieldElement operator-(FieldElement a) { return a *= Rational(-1); }

  friend bool operator==(const FieldElement& a, const FieldElement& b);
  friend bool operator==(const FieldElement& a, const Rational& b);
  friend std::strong_ordering operator<=>(const FieldElement& a, const FieldElement& b);
  friend std::strong_ordering operator<=>(const FieldElement& a, const Rational& b);

 private:
  void drop_leading_zeros();

  CosineFieldPointer field_;
  std::vector<Rational> coefficients_;
};

/// base^exponent; base^0 = 1. Cost: O(log exponent) multiplications of polynomials below the field's degree.
FieldElement power(const FieldElement& base, unsigned exponent);

/// cos(k pi/n). Throws InputError unless n >= 1 divides the field's N. Cost: O(log N) multiplications.
FieldElement cosine(const CosineFieldPointer& field, std::int64_t k, int n);

/// The same real number as an element of `larger`. Throws InputError unless its N is a multiple of the element's.
FieldElement embed(const FieldElement& element, const CosineFieldPointer& larger);

/// -1, 0 or 1.
int sign(const FieldElement& element);

/// Two decimal numbers around a real one, as text: "-0.25", "12", "1.5e-30".
struct DecimalEnclosure {
  std::string lower;
  std::string upper;
};

/// The tightest enclosure by decimals with that many significant digits, rounded outwards.
/// Throws InputError unless digits >= 1.
DecimalEnclosure enclose_decimal(const FieldElement& element, int digits = 12);

}  // namespace asts
