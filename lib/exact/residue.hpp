#pragma once

#include <cstdint>
#include <optional>

#include "lib/exact/errors.hpp"
#include "lib/exact/rational.hpp"

namespace asts {

/// A number modulo the prime 2^31 - 1, so that products fit into 64 bits.
///
/// Reducing modulo a prime is a one-sided filter: where a rational matrix has no denominator that the prime divides,
/// a minor that is not 0 modulo the prime is not 0, so full rank modulo the prime is full rank. A rank that drops
/// proves nothing.
///
/// Laws (each has a test that names it):
///  1. arithmetic: +, -, *, / satisfy the identities of a field.
///  2. reduction: residue_of is a homomorphism where it is defined.
class Residue {
 public:
  static constexpr std::uint64_t kPrime = 2'147'483'647;

  Residue() = default;
  /// The class of any integer.
  explicit Residue(std::int64_t integer) {
    const auto prime = static_cast<std::int64_t>(kPrime);
    value_ = static_cast<std::uint64_t>((integer % prime + prime) % prime);
  }

  /// The least representative that is not negative.
  std::uint64_t value() const { return value_; }
  bool is_zero() const { return value_ == 0; }

  friend Residue operator+(Residue a, Residue b) { return reduced(a.value_ + b.value_); }
  friend Residue operator-(Residue a, Residue b) { return reduced(a.value_ + kPrime - b.value_); }
  friend Residue operator*(Residue a, Residue b) { return reduced(a.value_ * b.value_); }
  /// Throws InputError when the divisor is 0.
  friend Residue operator/(Residue a, Residue b) {
    require(!b.is_zero(), "division of a residue by zero");
    return a * inverse(b);
  }
  Residue& operator+=(Residue other) { return *this = *this + other; }
  Residue& operator*=(Residue other) { return *this = *this * other; }
  friend bool operator==(Residue a, Residue b) = default;

 private:
  static Residue reduced(std::uint64_t value) {
    Residue result;
    result.value_ = value % kPrime;
    return result;
  }
  /// Fermat: b^(prime - 2).
  static Residue inverse(Residue b) {
    Residue result(1);
    for (std::uint64_t exponent = kPrime - 2; exponent != 0; exponent /= 2) {
      if (exponent % 2 == 1) result *= b;
      b *= b;
    }
    return result;
  }

  std::uint64_t value_ = 0;
};

/// The class of a rational number; nothing when the prime divides its denominator.
inline std::optional<Residue> residue_of(const Rational& value) {
  const mpq_srcptr raw = value.backend().data();
  const auto part = [](mpz_srcptr integer) {
    return Residue(static_cast<std::int64_t>(mpz_fdiv_ui(integer, Residue::kPrime)));
  };
  const Residue denominator = part(mpq_denref(raw));
  if (denominator.is_zero()) return std::nullopt;
  return part(mpq_numref(raw)) / denominator;
}

}  // namespace asts
