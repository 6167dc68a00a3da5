#include "lib/exact/cube_root_field.hpp"

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

/// The largest integer r with r^3 <= value. REQUIRES: value >= 0.
Integer cube_root_floor(const Integer& value) {
  Integer result;
  mpz_root(result.backend().data(), value.backend().data(), 3);
  return result;
}

Integer power(int base, int exponent) {
  Integer result;
  mpz_ui_pow_ui(result.backend().data(), static_cast<unsigned long>(base), static_cast<unsigned long>(exponent));
  return result;
}

/// 0 where m is no cube.
Integer root_of_cube(int m) {
  const Integer root = cube_root_floor(m);
  return root * root * root == m ? root : Integer(0);
}

Rational norm(const CubeRootNumber& x) {
  const Rational m = x.m();
  return x.a() * x.a() * x.a() + m * x.b() * x.b() * x.b() + m * m * x.c() * x.c() * x.c() -
         3 * m * x.a() * x.b() * x.c();
}

void require_same(const CubeRootNumber& x, const CubeRootNumber& y) {
  require(x.m() == y.m(), "two numbers are of different fields Q(m^(1/3))");
}

/// Adds coefficient * [lower, upper].
void add_multiple(RationalBounds& sum, const Rational& coefficient, const Rational& lower, const Rational& upper) {
  sum.lower += coefficient * (coefficient.sign() < 0 ? upper : lower);
  sum.upper += coefficient * (coefficient.sign() < 0 ? lower : upper);
}

}  // namespace

CubeRootNumber::CubeRootNumber(int m, const Rational& a, const Rational& b, const Rational& c)
    : m_(m), a_(a), b_(b), c_(c) {
  require(m >= 1, "the field Q(m^(1/3)) needs m >= 1");
  if (is_rational()) return;
  const Integer root = root_of_cube(m);
  if (root.is_zero()) return;
  a_ += Rational(root) * (b_ + Rational(root) * c_);
  b_ = 0;
  c_ = 0;
}

CubeRootNumber& CubeRootNumber::operator+=(const CubeRootNumber& other) {
  require_same(*this, other);
  a_ += other.a_;
  b_ += other.b_;
  c_ += other.c_;
  return *this;
}

CubeRootNumber& CubeRootNumber::operator-=(const CubeRootNumber& other) {
  require_same(*this, other);
  a_ -= other.a_;
  b_ -= other.b_;
  c_ -= other.c_;
  return *this;
}

CubeRootNumber& CubeRootNumber::operator*=(const CubeRootNumber& other) {
  require_same(*this, other);
  const Rational m = m_;
  const Rational a = a_ * other.a_ + m * (b_ * other.c_ + c_ * other.b_);
  const Rational b = a_ * other.b_ + b_ * other.a_ + m * c_ * other.c_;
  const Rational c = a_ * other.c_ + b_ * other.b_ + c_ * other.a_;
  return *this = CubeRootNumber(m_, a, b, c);
}

/// 1/(a + b t + c t^2) is (a^2 - m b c + (m c^2 - a b) t + (b^2 - a c) t^2) over the norm.
CubeRootNumber& CubeRootNumber::operator/=(const CubeRootNumber& other) {
  require_same(*this, other);
  const Rational n = norm(other);
  require(!n.is_zero(), "division by zero");
  const Rational m = m_;
  return *this *= CubeRootNumber(m_, (other.a_ * other.a_ - m * other.b_ * other.c_) / n,
                                 (m * other.c_ * other.c_ - other.a_ * other.b_) / n,
                                 (other.b_ * other.b_ - other.a_ * other.c_) / n);
}

CubeRootNumber& CubeRootNumber::operator*=(const Rational& factor) {
  a_ *= factor;
  b_ *= factor;
  c_ *= factor;
  return *this;
}

bool operator==(const CubeRootNumber& x, const CubeRootNumber& y) {
  require_same(x, y);
  return x.a_ == y.a_ && x.b_ == y.b_ && x.c_ == y.c_;
}

std::strong_ordering operator<=>(const CubeRootNumber& x, const CubeRootNumber& y) { return sign(x - y) <=> 0; }

int sign(const CubeRootNumber& number) { return norm(number).sign(); }

CubeRootNumber cube_root_power(int m, int k) {
  const int rest = ((k % 3) + 3) % 3;
  const int whole = (k - rest) / 3;
  Rational factor(power(m, whole < 0 ? -whole : whole));
  if (whole < 0) factor = 1 / factor;
  return {m, rest == 0 ? factor : Rational(0), rest == 1 ? factor : Rational(0), rest == 2 ? factor : Rational(0)};
}

RationalBounds rational_bounds(const CubeRootNumber& number, int places) {
  RationalBounds sum{number.a(), number.a()};
  if (number.is_rational()) return sum;
  const Integer unit = power(10, places);
  const Integer root = cube_root_floor(number.m() * unit * unit * unit);
  const Rational lower = Rational(root) / Rational(unit);
  const Rational upper = Rational(root + 1) / Rational(unit);
  add_multiple(sum, number.b(), lower, upper);
  add_multiple(sum, number.c(), lower * lower, upper * upper);
  return sum;
}

DecimalEnclosure enclose_decimal(const CubeRootNumber& number, int digits) {
  require(digits >= 1, "a decimal has at least one significant digit");
  if (number.is_rational()) return enclose_decimal(number.a(), digits);
  for (int places = digits + 8;; places *= 2) {
    const RationalBounds bounds = rational_bounds(number, places);
    if (const auto decimal = enclose_irrational(bounds.lower, bounds.upper, digits)) return *decimal;
  }
}

std::string to_string(const CubeRootNumber& number) {
  std::string result;
  const auto append = [&](const Rational& coefficient, const std::string& root) {
    if (coefficient.is_zero()) return;
    const bool minus = coefficient.sign() < 0;
    if (!result.empty()) result += minus ? " - " : " + ";
    if (result.empty() && minus) result += "-";
    const Rational magnitude = abs(coefficient);
    if (root.empty() || magnitude != 1) result += to_string(magnitude) + (root.empty() ? "" : " ");
    result += root;
  };
  const std::string base = std::to_string(number.m());
  append(number.a(), "");
  append(number.b(), base + "^(1/3)");
  append(number.c(), base + "^(2/3)");
  return result.empty() ? "0" : result;
}

}  // namespace asts
