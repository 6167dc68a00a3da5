/// Signs, order and decimal enclosures of field elements: what needs the real value and not only the coefficients.

#include "lib/exact/cosine_field.hpp"
#include "lib/exact/cosine_field_flint.hpp"
#include "lib/exact/errors.hpp"

namespace asts {
namespace {

using flint::Ball;

constexpr slong kFirstPrecision = 64;

struct RationalEnclosure {
  Rational lower;
  Rational upper;
};

/// A positive multiple of an element, as a polynomial with integer coefficients, and the factor.
struct IntegerPolynomial {
  flint::FmpzPoly polynomial;
  flint::Fmpz denominator;

  explicit IntegerPolynomial(const FieldElement& element) {
    flint::FmpqPoly rational;
    flint::set_polynomial(rational, element.coefficients());
    fmpq_poly_get_numerator(polynomial, rational);
    fmpq_poly_get_denominator(denominator, rational);
  }
};

/// A ball around polynomial(2 cos(pi/n)).
void evaluate(Ball& result, const flint::FmpzPoly& polynomial, int n, slong precision) {
  flint::Fmpq angle;
  fmpq_set_si(angle, 1, static_cast<ulong>(n));
  Ball generator;
  arb_cos_pi_fmpq(generator, angle, precision);
  arb_mul_2exp_si(generator, generator, 1);
  arb_fmpz_poly_evaluate_arb(result, polynomial, generator, precision);
}

/// REQUIRES: the element is irrational, in particular not zero; else no precision is enough.
int certified_sign(const FieldElement& element) {
  const IntegerPolynomial multiple(element);
  for (slong precision = kFirstPrecision;; precision *= 2) {
    Ball ball;
    evaluate(ball, multiple.polynomial, element.field()->n(), precision);
    if (arb_is_positive(ball) != 0) return 1;
    if (arb_is_negative(ball) != 0) return -1;
  }
}

Rational dyadic(const flint::Fmpz& mantissa, const flint::Fmpz& exponent) {
  Integer integer;
  fmpz_get_mpz(integer.backend().data(), mantissa);
  Rational result(integer);
  const slong shift = fmpz_get_si(exponent);
  const mpq_ptr raw = result.backend().data();
  if (shift >= 0) mpq_mul_2exp(raw, raw, static_cast<mp_bitcnt_t>(shift));
  if (shift < 0) mpq_div_2exp(raw, raw, static_cast<mp_bitcnt_t>(-shift));
  return result;
}

RationalEnclosure enclose(const IntegerPolynomial& multiple, int n, slong precision) {
  Ball ball;
  evaluate(ball, multiple.polynomial, n, precision);
  flint::Fmpz lower, upper, exponent;
  arb_get_interval_fmpz_2exp(lower, upper, exponent, ball);
  Integer denominator;
  fmpz_get_mpz(denominator.backend().data(), multiple.denominator);
  return {dyadic(lower, exponent) / Rational(denominator), dyadic(upper, exponent) / Rational(denominator)};
}

/// mantissa * 10^exponent.
struct Decimal {
  Integer mantissa = 0;
  long exponent = 0;
  bool operator==(const Decimal&) const = default;
};

Rational power_of_ten(long exponent) {
  Integer result;
  mpz_ui_pow_ui(result.backend().data(), 10, static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(1) / Rational(result) : Rational(result);
}

/// The e with 10^e <= |value| < 10^(e+1). REQUIRES: value is not 0.
long decade(const Rational& value) {
  const Rational magnitude = abs(value);
  const mpq_srcptr raw = magnitude.backend().data();
  // The sizes are exact or one too large, so the guess is off by at most two.
  long e =
      static_cast<long>(mpz_sizeinbase(mpq_numref(raw), 10)) - static_cast<long>(mpz_sizeinbase(mpq_denref(raw), 10));
  while (magnitude < power_of_ten(e)) --e;
  while (magnitude >= power_of_ten(e + 1)) ++e;
  return e;
}

/// The largest multiple of the last place of `digits` digits that is at most `value`. REQUIRES: value is not 0.
Decimal rounded_down(const Rational& value, int digits) {
  const long exponent = decade(value) - digits + 1;
  const Rational scaled = value * power_of_ten(-exponent);
  Decimal result{0, exponent};
  const mpq_srcptr raw = scaled.backend().data();
  mpz_fdiv_q(result.mantissa.backend().data(), mpq_numref(raw), mpq_denref(raw));
  return result;
}

std::string text_of(Decimal decimal) {
  if (decimal.mantissa.is_zero()) return "0";
  for (; decimal.mantissa % 10 == 0; ++decimal.exponent) decimal.mantissa /= 10;
  const std::string minus = decimal.mantissa < 0 ? "-" : "";
  std::string digits = to_string(Rational(abs(decimal.mantissa)));
  const long length = static_cast<long>(digits.size());
  const long point = length + decimal.exponent;  // how many digits stand before the decimal point
  constexpr long kMostZeros = 5;
  constexpr long kLongestInteger = 20;
  if (point < -kMostZeros || point > kLongestInteger) {
    if (length > 1) digits.insert(1, ".");
    return minus + digits + "e" + std::to_string(point - 1);
  }
  if (point <= 0) return minus + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  if (point >= length) return minus + digits + std::string(static_cast<std::size_t>(point - length), '0');
  return minus + digits.insert(static_cast<std::size_t>(point), ".");
}

DecimalEnclosure neighbours(const Decimal& lower, bool exact) {
  Decimal upper = lower;
  if (!exact) ++upper.mantissa;
  return {text_of(lower), text_of(upper)};
}

}  // namespace

int sign(const FieldElement& element) {
  if (element.is_rational()) return element.to_rational().sign();
  return certified_sign(element);
}

std::strong_ordering operator<=>(const FieldElement& a, const FieldElement& b) { return sign(a - b) <=> 0; }

std::strong_ordering operator<=>(const FieldElement& a, const Rational& b) { return a <=> FieldElement(a.field(), b); }

DecimalEnclosure enclose_decimal(const FieldElement& element, int digits) {
  require(digits >= 1, "a decimal has at least one significant digit");
  if (element.is_zero()) return {"0", "0"};
  if (element.is_rational()) {
    const Rational value = element.to_rational();
    const Decimal lower = rounded_down(value, digits);
    return neighbours(lower, Rational(lower.mantissa) * power_of_ten(lower.exponent) == value);
  }
  const IntegerPolynomial multiple(element);
  for (slong precision = kFirstPrecision;; precision *= 2) {
    const RationalEnclosure real = enclose(multiple, element.field()->n(), precision);
    if (real.lower.sign() != real.upper.sign() || real.lower.is_zero()) continue;
    // An irrational number is no decimal, so once the ball is small enough both its ends round to the same one.
    const Decimal lower = rounded_down(real.lower, digits);
    if (lower == rounded_down(real.upper, digits)) return neighbours(lower, false);
  }
}

}  // namespace asts
