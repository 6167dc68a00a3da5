#pragma once

#include <compare>
#include <string>

#include "lib/exact/decimal.hpp"
#include "lib/exact/rational.hpp"

namespace asts {

/// A real number a + b t + c t^2 with rational a, b, c and t = m^(1/3), m >= 1: an element of Q(m^(1/3)), where the
/// constants of Section 7 and the bounds of Appendix A live. A value, computed with and compared like a number.
///
/// Where m is the cube of an integer, t is that integer and everything is rational; it is stored so (b = c = 0).
/// Otherwise x^3 - m has no rational root, so 1, t, t^2 are independent over the rationals and the representation is
/// unique; the norm a^3 + m b^3 + m^2 c^3 - 3 m a b c is the number times |a + b w t + c w^2 t^2|^2 (w a complex third
/// root of 1), which is positive unless the number is 0, so the sign of the norm is the sign of the number.
///
/// Laws (each has a test that names it):
///  1. arithmetic: +, -, *, / satisfy the identities of a field; t^3 = m; x * (y / x) = y.
///  2. order: <=> is the order of the real numbers, compatible with + and with * by positive numbers, and agrees with
///     rational bounds of t.
///  3. cubes: where m = r^3, t == r.
///  4. enclosure: as enclose_decimal of a rational number; rational_bounds hold the number.
///
/// Operations of two numbers throw InputError when their m differ.
class CubeRootNumber {
 public:
  /// Throws InputError unless m >= 1.
  CubeRootNumber(int m, const Rational& a, const Rational& b = 0, const Rational& c = 0);

  int m() const { return m_; }
  /// The coefficients of 1, t, t^2; for a cube the value, 0, 0.
  const Rational& a() const { return a_; }
  const Rational& b() const { return b_; }
  const Rational& c() const { return c_; }
  bool is_rational() const { return b_.is_zero() && c_.is_zero(); }

  CubeRootNumber& operator+=(const CubeRootNumber& other);
  CubeRootNumber& operator-=(const CubeRootNumber& other);
  CubeRootNumber& operator*=(const CubeRootNumber& other);
  /// Throws InputError when the divisor is 0.
  CubeRootNumber& operator/=(const CubeRootNumber& other);
  CubeRootNumber& operator*=(const Rational& factor);

  friend CubeRootNumber operator+(CubeRootNumber x, const CubeRootNumber& y) { return x += y; }
  friend CubeRootNumber operator-(CubeRootNumber x, const CubeRootNumber& y) { return x -= y; }
  friend CubeRootNumber operator*(CubeRootNumber x, const CubeRootNumber& y) { return x *= y; }
  friend CubeRootNumber operator/(CubeRootNumber x, const CubeRootNumber& y) { return x /= y; }
  friend CubeRootNumber operator+(const CubeRootNumber& x, const Rational& y) { return x + CubeRootNumber(x.m_, y); }
  friend CubeRootNumber operator-(const CubeRootNumber& x, const Rational& y) { return x - CubeRootNumber(x.m_, y); }
  friend CubeRootNumber operator*(CubeRootNumber x, const Rational& y) { return x *= y; }

  friend bool operator==(const CubeRootNumber& x, const CubeRootNumber& y);
  friend std::strong_ordering operator<=>(const CubeRootNumber& x, const CubeRootNumber& y);
  friend bool operator==(const CubeRootNumber& x, const Rational& y) { return x == CubeRootNumber(x.m_, y); }
  friend std::strong_ordering operator<=>(const CubeRootNumber& x, const Rational& y) {
    return x <=> CubeRootNumber(x.m_, y);
  }

 private:
  int m_;
  Rational a_, b_, c_;
};

/// -1, 0 or 1.
int sign(const CubeRootNumber& number);

/// m^(k/3), for k of either sign. Cost: one power of an integer.
CubeRootNumber cube_root_power(int m, int k);

/// Two rationals around a number: equal where it is rational, and the closer the more places are asked for.
struct RationalBounds {
  Rational lower;
  Rational upper;
};

/// Bounds by rational bounds of t that are 10^-places apart. REQUIRES: places >= 0.
RationalBounds rational_bounds(const CubeRootNumber& number, int places);

/// The tightest enclosure by decimals with that many significant digits. Throws InputError unless digits >= 1.
DecimalEnclosure enclose_decimal(const CubeRootNumber& number, int digits = 12);

/// "5/2 - 1/3 m^(1/3) + 2 m^(2/3)" with the value of m, zero terms left out: "5/2 - 1/3 5^(1/3) + 2 5^(2/3)".
std::string to_string(const CubeRootNumber& number);

}  // namespace asts
