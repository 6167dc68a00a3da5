#include "lib/exact/decimal.hpp"

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

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

DecimalEnclosure enclose_decimal(const Rational& value, int digits) {
  require(digits >= 1, "a decimal has at least one significant digit");
  if (value.is_zero()) return {"0", "0"};
  const Decimal lower = rounded_down(value, digits);
  return neighbours(lower, Rational(lower.mantissa) * power_of_ten(lower.exponent) == value);
}

std::optional<DecimalEnclosure> enclose_irrational(const Rational& lower, const Rational& upper, int digits) {
  require(digits >= 1, "a decimal has at least one significant digit");
  if (lower.sign() != upper.sign() || lower.is_zero()) return std::nullopt;
  const Decimal rounded = rounded_down(lower, digits);
  if (rounded != rounded_down(upper, digits)) return std::nullopt;
  return neighbours(rounded, false);
}

}  // namespace asts
