#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "lib/exact/rational.hpp"

namespace asts {

/// A rational number that takes 32 bytes and no allocation when numerator and denominator fit into 63 bits, and a
/// shared GMP rational otherwise. Always in lowest terms. It is stored and handed on; arithmetic is done on Rational,
/// or on `numerator`/`denominator` where `is_small()`.
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

 private:
  std::int64_t numerator_ = 0;
  std::int64_t denominator_ = 1;
  std::shared_ptr<const Rational> wide_;
};

}  // namespace asts
