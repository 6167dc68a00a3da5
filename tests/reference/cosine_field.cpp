#include "tests/reference/cosine_field.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>

namespace asts::reference {

namespace {

using Interval = std::array<Rational, 2>;

Rational value_at(const RationalPolynomial& polynomial, const Rational& x) {
  Rational result = 0;
  for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) result = result * x + *c;
  return result;
}

RationalPolynomial derivative(const RationalPolynomial& polynomial) {
  RationalPolynomial result;
  for (std::size_t i = 1; i < polynomial.size(); ++i) result.push_back(polynomial[i] * i);
  return result;
}

/// Minus the remainder of a by b, the next member of Sturm's sequence.
RationalPolynomial minus_remainder(RationalPolynomial a, const RationalPolynomial& b) {
  while (a.size() >= b.size()) {
    const Rational factor = a.back() / b.back();
    for (std::size_t i = 0; i < b.size(); ++i) a[a.size() - b.size() + i] -= factor * b[i];
    while (!a.empty() && a.back() == 0) a.pop_back();
  }
  for (Rational& c : a) c = -c;
  return a;
}

int sign_changes(const std::vector<RationalPolynomial>& sturm, const Rational& x) {
  int changes = 0, last = 0;
  for (const RationalPolynomial& member : sturm) {
    const int s = value_at(member, x).sign();
    if (s != 0 && last != 0 && s != last) ++changes;
    if (s != 0) last = s;
  }
  return changes;
}

/// An interval (lower, 2] with exactly one root in it, the largest one; all roots are in [-2, 2].
Interval isolate_largest_root(const RationalPolynomial& polynomial) {
  std::vector<RationalPolynomial> sturm{polynomial, derivative(polynomial)};
  while (sturm.back().size() > 1) sturm.push_back(minus_remainder(sturm[sturm.size() - 2], sturm.back()));
  Interval result{Rational(-3), Rational(2)};
  while (sign_changes(sturm, result[0]) - sign_changes(sturm, result[1]) > 1) {
    const Rational middle = (result[0] + result[1]) / 2;
    const bool above = sign_changes(sturm, middle) - sign_changes(sturm, result[1]) >= 1;
    result[above ? 0 : 1] = middle;
  }
  return result;
}

/// Bisects [lower, upper], which holds one simple root, the polynomial being positive above it.
Interval bisect(const RationalPolynomial& polynomial, Interval interval, int bits) {
  const Rational target = Rational(1) / Rational(Integer(1) << bits);
  while (interval[1] - interval[0] > target) {
    const Rational middle = (interval[0] + interval[1]) / 2;
    const int s = value_at(polynomial, middle).sign();
    if (s == 0) return {middle, middle};
    interval[s < 0 ? 0 : 1] = middle;
  }
  return interval;
}

Interval product(const Interval& a, const Interval& b) {
  const std::array<Rational, 4> corners{a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]};
  return {*std::min_element(corners.begin(), corners.end()), *std::max_element(corners.begin(), corners.end())};
}

}  // namespace

CosineField::CosineField(int n) : n_(n), minimal_(minimal_polynomial(2 * n)) {
  isolated_ = bisect(minimal_, isolate_largest_root(minimal_), 64);
}

const CosineField& CosineField::get(int n) {
  static thread_local std::map<int, std::unique_ptr<CosineField>> fields;
  std::unique_ptr<CosineField>& field = fields[n];
  if (!field) field = std::make_unique<CosineField>(n);
  return *field;
}

Number CosineField::rational(const Rational& value) const {
  Number result(degree());
  result[0] = value;
  return result;
}

Number CosineField::twice_cosine(int k) const {
  Number g(degree() + 1);
  g[1] = 1;
  g = multiply(rational(1), g);
  Number previous = rational(2), current = g;
  if (k == 0) return previous;
  for (int i = 1; i < k; ++i) {
    Number next = subtract(multiply(g, current), previous);
    previous = std::move(current);
    current = std::move(next);
  }
  return current;
}

Number CosineField::add(const Number& a, const Number& b) const {
  Number result = a;
  for (std::size_t i = 0; i < b.size(); ++i) result[i] += b[i];
  return result;
}

Number CosineField::subtract(const Number& a, const Number& b) const {
  Number result = a;
  for (std::size_t i = 0; i < b.size(); ++i) result[i] -= b[i];
  return result;
}

Number CosineField::multiply(const Number& a, const Number& b) const {
  Number result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; a[i] != 0 && j < b.size(); ++j)
      if (b[j] != 0) result[i + j] += a[i] * b[j];
  for (std::size_t top = result.size(); top-- > degree();) {
    if (result[top] == 0) continue;
    const Rational factor = result[top];  // the minimal polynomial is monic
    for (std::size_t i = 0; i <= degree(); ++i)
      if (minimal_[i] != 0) result[top - degree() + i] -= factor * minimal_[i];
  }
  result.resize(degree());
  return result;
}

Number CosineField::scale(const Rational& factor, Number a) const {
  for (Rational& c : a) c *= factor;
  return a;
}

int CosineField::sign(const Number& a) const {
  if (is_rational(a)) return a[0].sign();
  for (int bits = 64;; bits *= 2) {
    const Interval bounds = enclosure(a, bits);
    if (bounds[0] > 0) return 1;
    if (bounds[1] < 0) return -1;
  }
}

std::array<Rational, 2> CosineField::enclosure(const Number& a, int bits) const {
  const Interval g = root_interval(bits);
  Interval result{Rational(0), Rational(0)};
  for (auto c = a.rbegin(); c != a.rend(); ++c) {
    result = product(result, g);
    result[0] += *c;
    result[1] += *c;
  }
  return result;
}

std::array<Rational, 2> CosineField::root_interval(int bits) const {
  return bits <= 64 ? isolated_ : bisect(minimal_, isolated_, bits);
}

Number CosineField::embed(const Number& a, const CosineField& larger) const {
  if (larger.n() % n_ != 0) throw std::logic_error("no embedding of these fields");
  const Number g = larger.twice_cosine(larger.n() / n_);
  Number result = larger.rational(0);
  for (auto c = a.rbegin(); c != a.rend(); ++c) result = larger.add(larger.multiply(result, g), larger.rational(*c));
  return result;
}

bool is_zero(const Number& a) {
  return std::all_of(a.begin(), a.end(), [](const Rational& c) { return c == 0; });
}

bool is_rational(const Number& a) {
  return std::all_of(a.begin() + 1, a.end(), [](const Rational& c) { return c == 0; });
}

}  // namespace asts::reference
