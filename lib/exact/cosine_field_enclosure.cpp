/// Signs, order and decimal enclosures of field elements: what needs the real value and not only the coefficients.

#include "lib/exact/cosine_field.hpp"
#include "lib/exact/cosine_field_flint.hpp"
#include "lib/exact/decimal.hpp"
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

}  // namespace

int sign(const FieldElement& element) {
  if (element.is_rational()) return element.to_rational().sign();
  return certified_sign(element);
}

std::strong_ordering operator<=>(const FieldElement& a, const FieldElement& b) { return sign(a - b) <=> 0; }

std::strong_ordering operator<=>(const FieldElement& a, const Rational& b) { return a <=> FieldElement(a.field(), b); }

DecimalEnclosure enclose_decimal(const FieldElement& element, int digits) {
  if (element.is_rational()) return enclose_decimal(element.to_rational(), digits);
  const IntegerPolynomial multiple(element);
  for (slong precision = kFirstPrecision;; precision *= 2) {
    const RationalEnclosure real = enclose(multiple, element.field()->n(), precision);
    if (const auto decimal = enclose_irrational(real.lower, real.upper, digits)) return *decimal;
  }
}

}  // namespace asts
