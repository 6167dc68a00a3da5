#include "lib/exact/rational.hpp"

#include <algorithm>

#include "lib/exact/errors.hpp"

namespace asts {
namespace {

bool is_digit_string(std::string_view text) {
  // Not std::isdigit: what a digit is must not depend on the locale.
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// REQUIRES: is_digit_string(digits).
Integer integer_of_digits(std::string_view digits) {
  Integer result;
  // Not Integer's own constructor: it reads a leading zero as "octal".
  const int status = mpz_set_str(result.backend().data(), std::string(digits).c_str(), 10);
  ensure(status == 0, "a string of digits is a number");
  return result;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.size() <= kLongest) return "\"" + std::string(text) + "\"";
  return "\"" + std::string(text.substr(0, kLongest)) + "...\"";
}

std::string digits_of(mpz_srcptr value) {
  std::string text(mpz_sizeinbase(value, 10) + 2, '\0');  // a sign and the terminating zero
  mpz_get_str(text.data(), 10, value);
  text.resize(text.find('\0'));
  return text;
}

}  // namespace

std::variant<Rational, std::string> parse_rational(std::string_view text) {
  const bool negative = text.starts_with('-');
  const std::string_view fraction = negative ? text.substr(1) : text;
  const std::size_t slash = fraction.find('/');
  const bool has_slash = slash != std::string_view::npos;
  const std::string_view above = fraction.substr(0, slash);
  const std::string_view below = has_slash ? fraction.substr(slash + 1) : std::string_view("1");
  if (!is_digit_string(above) || !is_digit_string(below)) return quoted(text) + " is not an integer or a fraction";
  if (below.find_first_not_of('0') == std::string_view::npos) return quoted(text) + " has a zero denominator";

  Integer numerator = integer_of_digits(above);
  if (negative) numerator = -numerator;
  return Rational(numerator, integer_of_digits(below));  // from two integers it does come in lowest terms
}

std::string to_string(const Rational& value) {
  Rational canonical = value;
  ensure(mpz_sgn(mpq_denref(canonical.backend().data())) != 0, "a rational number has a nonzero denominator");
  mpq_canonicalize(canonical.backend().data());  // "2/4" does come out of Rational's own string constructor
  const mpq_srcptr raw = canonical.backend().data();
  std::string text = digits_of(mpq_numref(raw));
  if (mpz_cmp_ui(mpq_denref(raw), 1) != 0) text += "/" + digits_of(mpq_denref(raw));
  return text;
}

}  // namespace asts
