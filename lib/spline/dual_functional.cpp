#include "lib/spline/dual_functional.hpp"

#include <algorithm>
#include <functional>
#include <memory>

#include "lib/exact/errors.hpp"

namespace asts {
namespace {

using Vector = std::span<const Rational>;
using IntegerVector = std::span<const Integer>;

/// Values kept by one object before it starts over: far more than pairs of vectors differ in one mesh, and a bound on
/// the memory of a long campaign.
constexpr std::size_t kMostValues = 1U << 18U;

/// Every entry of `inner` that lies in the closed span of `outer` is an entry of `outer`.
bool entries_in_span_are_entries(Vector inner, Vector outer) {
  return std::all_of(inner.begin(), inner.end(), [&](const Rational& entry) {
    return entry < outer.front() || entry > outer.back() || std::binary_search(outer.begin(), outer.end(), entry);
  });
}

bool strictly_increasing(Vector x) { return std::adjacent_find(x.begin(), x.end(), std::greater_equal<>()) == x.end(); }

/// X and X~ behind each other under the one positive affine map that makes them integers without a common divisor, the
/// least of them 0. Two pairs have the same form exactly when a positive affine map takes one to the other.
std::vector<Integer> canonical_form(Vector x, Vector x_tilde) {
  Integer common = 1;
  for (const Vector vector : {x, x_tilde}) {
    for (const Rational& entry : vector) {
      mpz_lcm(common.backend().data(), common.backend().data(), mpq_denref(entry.backend().data()));
    }
  }
  std::vector<Integer> result;
  result.reserve(x.size() + x_tilde.size());
  for (const Vector vector : {x, x_tilde}) {
    for (const Rational& entry : vector) {
      const mpq_srcptr raw = entry.backend().data();
      Integer& scaled = result.emplace_back();
      mpz_divexact(scaled.backend().data(), common.backend().data(), mpq_denref(raw));
      mpz_mul(scaled.backend().data(), scaled.backend().data(), mpq_numref(raw));
    }
  }
  const Integer origin = std::min(result[0], result[x.size()]);
  Integer divisor = 0;
  for (Integer& entry : result) {
    entry -= origin;
    mpz_gcd(divisor.backend().data(), divisor.backend().data(), entry.backend().data());
  }
  for (Integer& entry : result) mpz_divexact(entry.backend().data(), entry.backend().data(), divisor.backend().data());
  return result;
}

/// The factor of G(u(x~_k)) in the closed form.
/// (x~_k - x_2)...(x~_k - x_(p+1)) (x~_(p+2) - x~_1) / product over i != k of (x~_k - x~_i).
Rational weight(IntegerVector x, IntegerVector x_tilde, std::size_t k) {
  Integer numerator = x_tilde.back() - x_tilde.front();
  for (const Integer& entry : x.subspan(1, x.size() - 2)) numerator *= x_tilde[k] - entry;
  Integer denominator = 1;
  for (std::size_t i = 0; i < x_tilde.size(); ++i) {
    if (i != k) denominator *= x_tilde[k] - x_tilde[i];
  }
  return {numerator, denominator};
}

}  // namespace

bool vectors_overlap(Vector x, Vector x_tilde) {
  return entries_in_span_are_entries(x, x_tilde) && entries_in_span_are_entries(x_tilde, x);
}

DualFunctional::DualFunctional(int degree) : degree_(degree) {
  require(degree >= 1 && degree % 2 == 1, "dual functionals are for odd degrees from 1 on");
  field_ = std::make_shared<const CosineField>(degree + 1);
}

const std::vector<FieldElement>& DualFunctional::nodes() {
  if (!nodes_.empty()) return nodes_;
  for (int j = 0; j <= degree_ + 1; ++j) nodes_.push_back(cosine(field_, degree_ + 1 - j, degree_ + 1));
  return nodes_;
}

FieldElement DualFunctional::perfect_antiderivative(const Rational& u) {
  const auto known = antiderivatives_.find(u);
  if (known != antiderivatives_.end()) return known->second;

  FieldElement result(field_, Rational(u >= 1 ? 1 : 0));
  if (u > -1 && u < 1) {
    const FieldElement point(field_, u);
    for (int j = 0; j <= degree_; ++j) {
      const FieldElement distance = point - nodes()[static_cast<std::size_t>(j)];
      if (sign(distance) <= 0) break;  // the nodes increase
      FieldElement term = power(distance, static_cast<unsigned>(degree_ + 1));
      if (j == 0) term /= Rational(2);
      if (j % 2 == 0) result += term;  // (-1)^(p+1-j) = (-1)^j
      if (j % 2 == 1) result -= term;
    }
    result *= Rational(Integer(1) << degree_, Integer(degree_ + 1));
  }
  if (antiderivatives_.size() >= kMostValues) antiderivatives_.clear();
  return antiderivatives_.emplace(u, std::move(result)).first->second;
}

FieldElement DualFunctional::evaluate(IntegerVector x, IntegerVector x_tilde) {
  Rational rational_part = 0;
  FieldElement irrational_part(field_, Rational(0));
  const Integer length = x.back() - x.front();
  for (std::size_t k = 0; k < x_tilde.size(); ++k) {
    const Integer& entry = x_tilde[k];
    if (entry <= x.front()) continue;  // G = 0
    const bool inside = entry < x.back();
    if (inside && std::binary_search(x.begin(), x.end(), entry)) continue;
    const Rational factor = weight(x, x_tilde, k);
    if (!inside) {
      rational_part += factor;  // G = 1
    } else {
      const Rational u(2 * entry - x.front() - x.back(), length);
      irrational_part += perfect_antiderivative(u) * factor;
    }
  }
  return irrational_part + FieldElement(field_, rational_part);
}

FieldElement DualFunctional::lambda(Vector x, Vector x_tilde) {
  const auto size = static_cast<std::size_t>(degree_) + 2;
  require(x.size() == size && x_tilde.size() == size, "an index vector of degree p has p+2 entries");
  require(strictly_increasing(x) && strictly_increasing(x_tilde), "an index vector increases strictly");
  if (x.back() <= x_tilde.front() || x_tilde.back() <= x.front()) return {field_, Rational(0)};

  std::vector<Integer> form = canonical_form(x, x_tilde);
  const auto known = values_.find(form);
  if (known != values_.end()) return known->second;
  FieldElement result = evaluate(IntegerVector(form).first(size), IntegerVector(form).last(size));
  if (values_.size() >= kMostValues) values_.clear();
  return values_.emplace(std::move(form), std::move(result)).first->second;
}

}  // namespace asts
