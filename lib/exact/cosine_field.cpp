#include "lib/exact/cosine_field.hpp"

#include <algorithm>
#include <utility>

#include "lib/exact/cosine_field_flint.hpp"
#include "lib/exact/errors.hpp"

namespace asts {
namespace {

using flint::FmpqPoly;

void set_modulus(FmpqPoly& result, const CosineField& field) {
  const std::vector<Integer>& integers = field.minimal_polynomial();
  flint::set_polynomial(result, std::vector<Rational>(integers.begin(), integers.end()));
}

void require_same_field(const FieldElement& a, const FieldElement& b) {
  require(a.field() == b.field() || a.field()->n() == b.field()->n(), "the elements belong to different fields");
}

/// The pair 2 cos(k a), 2 cos((k+1) a) where `first` = 2 cos(a), by doubling: C_2k = C_k^2 - 2, C_2k+1 = C_k C_k+1 -
/// C_1.
std::pair<FieldElement, FieldElement> doubled_cosines(const FieldElement& first, std::int64_t k) {
  const FieldElement two(first.field(), Rational(2));
  if (k == 0) return {two, first};
  const auto [low, high] = doubled_cosines(first, k / 2);
  FieldElement middle = low * high - first;
  if (k % 2 == 0) return {low * low - two, std::move(middle)};
  return {std::move(middle), high * high - two};
}

/// 2 cos(k pi/N) in the field of N.
FieldElement doubled_cosine(const CosineFieldPointer& field, std::int64_t k) {
  const std::int64_t period = 2 * std::int64_t{field->n()};
  std::int64_t angle = ((k % period) + period) % period;
  angle = std::min(angle, period - angle);  // the cosine is even
  const FieldElement generator(field, std::vector<Rational>{0, 1});
  return doubled_cosines(generator, angle).first;
}

}  // namespace

CosineField::CosineField(int n) : n_(n), degree_(1) {
  require(n >= 1, "the field of 2 cos(pi/N) needs N >= 1");
  if (n > 1) degree_ = static_cast<int>(n_euler_phi(2 * static_cast<ulong>(n)) / 2);
}

const std::vector<Integer>& CosineField::minimal_polynomial() const {
  std::call_once(once_, [this] {
    flint::FmpzPoly polynomial;
    fmpz_poly_cos_minpoly(polynomial, 2 * static_cast<ulong>(n_));  // FLINT's n stands for 2 cos(2 pi/n)
    std::vector<Integer> coefficients(static_cast<std::size_t>(fmpz_poly_length(polynomial)));
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      fmpz_poly_get_coeff_mpz(coefficients[i].backend().data(), polynomial, static_cast<slong>(i));
    }
    ensure(coefficients.size() == static_cast<std::size_t>(degree_) + 1, "the minimal polynomial has degree phi(2N)/2");
    minimal_polynomial_ = std::move(coefficients);
  });
  return minimal_polynomial_;
}

FieldElement::FieldElement(CosineFieldPointer field, const Rational& value)
    : FieldElement(std::move(field), std::vector<Rational>{value}) {}

FieldElement::FieldElement(CosineFieldPointer field, std::vector<Rational> coefficients)
    : field_(std::move(field)), coefficients_(std::move(coefficients)) {
  require(field_ != nullptr, "a field element needs a field");
  if (coefficients_.size() > static_cast<std::size_t>(field_->degree())) {
    FmpqPoly polynomial, modulus;
    flint::set_polynomial(polynomial, coefficients_);
    set_modulus(modulus, *field_);
    fmpq_poly_rem(polynomial, polynomial, modulus);
    coefficients_ = flint::coefficients_of(polynomial);
  }
  drop_leading_zeros();
}

void FieldElement::drop_leading_zeros() {
  while (!coefficients_.empty() && coefficients_.back().is_zero()) coefficients_.pop_back();
}

Rational FieldElement::to_rational() const {
  require(is_rational(), "the field element is irrational");
  return is_zero() ? Rational(0) : coefficients_.front();
}

FieldElement& FieldElement::operator+=(const FieldElement& other) {
  require_same_field(*this, other);
  if (coefficients_.size() < other.coefficients_.size()) coefficients_.resize(other.coefficients_.size());
  for (std::size_t i = 0; i < other.coefficients_.size(); ++i) coefficients_[i] += other.coefficients_[i];
  drop_leading_zeros();
  return *this;
}

FieldElement& FieldElement::operator-=(const FieldElement& other) {
  require_same_field(*this, other);
  if (coefficients_.size() < other.coefficients_.size()) coefficients_.resize(other.coefficients_.size());
  for (std::size_t i = 0; i < other.coefficients_.size(); ++i) coefficients_[i] -= other.coefficients_[i];
  drop_leading_zeros();
  return *this;
}

FieldElement& FieldElement::operator*=(const FieldElement& other) {
  require_same_field(*this, other);
  if (other.is_rational()) return *this *= other.to_rational();
  if (is_rational()) return *this = other * to_rational();
  FmpqPoly left, right, modulus;
  flint::set_polynomial(left, coefficients_);
  flint::set_polynomial(right, other.coefficients_);
  set_modulus(modulus, *field_);
  fmpq_poly_mul(left, left, right);
  fmpq_poly_rem(left, left, modulus);
  coefficients_ = flint::coefficients_of(left);
  return *this;
}

FieldElement& FieldElement::operator*=(const Rational& factor) {
  for (Rational& coefficient : coefficients_) coefficient *= factor;
  drop_leading_zeros();  // the factor may be 0
  return *this;
}

FieldElement& FieldElement::operator/=(const Rational& divisor) {
  require(!divisor.is_zero(), "division of a field element by zero");
  for (Rational& coefficient : coefficients_) coefficient /= divisor;
  return *this;
}

bool operator==(const FieldElement& a, const FieldElement& b) {
  require_same_field(a, b);
  return a.coefficients_ == b.coefficients_;
}

bool operator==(const FieldElement& a, const Rational& b) { return a.is_rational() && a.to_rational() == b; }

FieldElement power(const FieldElement& base, unsigned exponent) {
  FmpqPoly result, square, modulus;
  fmpq_poly_one(result);
  flint::set_polynomial(square, base.coefficients());
  if (!base.is_rational()) set_modulus(modulus, *base.field());
  const auto multiply = [&](FmpqPoly& target) {
    fmpq_poly_mul(target, target, square);
    if (!base.is_rational()) fmpq_poly_rem(target, target, modulus);
  };
  for (; exponent != 0; exponent /= 2) {
    if (exponent % 2 == 1) multiply(result);
    if (exponent > 1) multiply(square);
  }
  return {base.field(), flint::coefficients_of(result)};
}

FieldElement cosine(const CosineFieldPointer& field, std::int64_t k, int n) {
  require(n >= 1 && field->n() % n == 0, "cos(k pi/n) lies in the field of N where n divides N");
  const std::int64_t angle = (k % (2 * std::int64_t{n})) * (field->n() / n);
  return doubled_cosine(field, angle) / Rational(2);
}

FieldElement embed(const FieldElement& element, const CosineFieldPointer& larger) {
  const int n = element.field()->n();
  require(larger->n() % n == 0, "a field of N embeds into the fields of its multiples");
  const std::vector<Rational>& coefficients = element.coefficients();
  FieldElement result(larger, Rational(0));
  if (coefficients.empty()) return result;
  const FieldElement image = doubled_cosine(larger, larger->n() / n);
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c)
    result = result * image + FieldElement(larger, *c);
  return result;
}

}  // namespace asts
