#include "lib/exact/compact_rational.hpp"

#include <bit>
#include <numeric>

namespace asts {
namespace {

/// Digits that cannot overflow 64 bits: 10^18 < 2^63.
constexpr std::ptrdiff_t kSafeDigits = 18;

/// Reads digits from `cursor` on and moves it behind the last one. Wraps when there are too many: check how far the
/// cursor went before using the value.
std::uint64_t read_digits(const char*& cursor, const char* end) {
  std::uint64_t value = 0;
  for (; cursor != end; ++cursor) {
    const auto digit = static_cast<unsigned char>(*cursor - '0');
    if (digit > 9) break;
    value = value * 10 + digit;
  }
  return value;
}

/// REQUIRES: denominator > 0. Grids with m = 2 are so common that their denominators are worth a shift.
std::uint64_t common_divisor(std::uint64_t numerator, std::uint64_t denominator) {
  if (!std::has_single_bit(denominator)) return std::gcd(numerator, denominator);
  return std::uint64_t{1} << std::countr_zero(numerator | denominator);
}

CompactRational fraction(bool negative, std::uint64_t numerator, std::uint64_t denominator) {
  if (denominator != 1) {
    const std::uint64_t divisor = common_divisor(numerator, denominator);
    numerator /= divisor;
    denominator /= divisor;
  }
  const auto magnitude = static_cast<std::int64_t>(numerator);
  return CompactRational::lowest_terms(negative ? -magnitude : magnitude, static_cast<std::int64_t>(denominator));
}

std::variant<CompactRational, std::string> parse_any(std::string_view text) {
  auto result = parse_rational(text);
  if (auto* reason = std::get_if<std::string>(&result)) return std::move(*reason);
  return CompactRational(std::get<Rational>(result));
}

}  // namespace

CompactRational::CompactRational(const Rational& value) {
  Rational canonical = value;
  mpq_canonicalize(canonical.backend().data());
  const mpz_srcptr above = mpq_numref(canonical.backend().data());
  const mpz_srcptr below = mpq_denref(canonical.backend().data());
  static_assert(sizeof(long) == sizeof(std::int64_t), "GMP's signed long is the small integer");
  if (mpz_fits_slong_p(above) != 0 && mpz_fits_slong_p(below) != 0) {
    numerator_ = mpz_get_si(above);
    denominator_ = mpz_get_si(below);
  } else {
    wide_ = std::make_shared<const Rational>(std::move(canonical));
  }
}

Rational CompactRational::value() const { return is_small() ? Rational(numerator_, denominator_) : *wide_; }

std::variant<CompactRational, std::string> parse_compact(std::string_view text) {
  const char* cursor = text.data();
  const char* const end = cursor + text.size();
  const bool negative = cursor != end && *cursor == '-';
  if (negative) ++cursor;
  const char* start = cursor;
  const std::uint64_t numerator = read_digits(cursor, end);
  // Everything out of the ordinary, errors included, is parse_rational's business: one grammar, one wording.
  if (cursor == start || cursor - start > kSafeDigits) return parse_any(text);
  if (cursor == end) return fraction(negative, numerator, 1);
  if (*cursor != '/') return parse_any(text);
  start = ++cursor;
  const std::uint64_t denominator = read_digits(cursor, end);
  if (cursor != end || cursor == start || cursor - start > kSafeDigits || denominator == 0) return parse_any(text);
  return fraction(negative, numerator, denominator);
}

}  // namespace asts
