#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "lib/exact/rational.hpp"

namespace asts {

/// A rational number that takes 32 bytes and no allocation when numerator and denominator fit into std::int64_t, and a
/// shared GMP rational otherwise. Always in lowest terms. It is stored and handed on; arithmetic is done on Rational,
/// or on `numerator`/`denominator` where `is_small()`.
///
/// Laws (each has a test that names it):
///  1. round trip: CompactRational(r).value() == r.
///  2. one form a number: is_small() holds exactly when both parts fit, so == compares parts.
class CompactRational {
 public:
  CompactRational() = default;
  explicit CompactRational(std::int64_t integer) : numerator_(integer) {}
  explicit CompactRational(const Rational& value);

  /// The fraction numerator/denominator. REQUIRES: denominator > 0, gcd(numerator, denominator) = 1.
  static CompactRational lowest_terms(std::int64_t numerator, std::int64_t denominator) {
    CompactRational result;
    result.numerator_ = numerator;
    result.denominator_ = denominator;
    return result;
  }

  bool is_small() const { return wide_ == nullptr; }
  /// REQUIRES: is_small().
  std::int64_t numerator() const { return numerator_; }
  /// REQUIRES: is_small(). Positive.
  std::int64_t denominator() const { return denominator_; }

  Rational value() const;

  friend bool operator==(const CompactRational& a, const CompactRational& b) {
    if (a.is_small() != b.is_small()) return false;
    if (!a.is_small()) return *a.wide_ == *b.wide_;
    return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_;
  }

 private:
  std::int64_t numerator_ = 0;
  std::int64_t denominator_ = 1;
  std::shared_ptr<const Rational> wide_;
};

/// parse_rational for texts that come by the million: the same grammar, value and reason on every text.
/// Cost: no allocation and one 64-bit gcd while numerator and denominator have at most 18 digits each.
std::variant<CompactRational, std::string> parse_compact(std::string_view text);

}  // namespace asts
