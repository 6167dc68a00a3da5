#include <map>
#include <stdexcept>

#include "tests/reference/cosine_field.hpp"

namespace asts::reference {

namespace {

void trim(RationalPolynomial& polynomial) {
  while (!polynomial.empty() && polynomial.back() == 0) polynomial.pop_back();
}

RationalPolynomial minus(RationalPolynomial a, const RationalPolynomial& b) {
  if (a.size() < b.size()) a.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) a[i] -= b[i];
  trim(a);
  return a;
}

/// V_k with V_k(2 cos t) = 2 cos(k t): V_0 = 2, V_1 = x, V_{k+1} = x V_k - V_{k-1}.
RationalPolynomial chebyshev(int k) {
  RationalPolynomial previous{Rational(2)}, current{Rational(0), Rational(1)};
  if (k == 0) return previous;
  for (int i = 1; i < k; ++i) {
    RationalPolynomial next = current;
    next.insert(next.begin(), Rational(0));
    next = minus(next, previous);
    previous = current;
    current = next;
  }
  return current;
}

}  // namespace

RationalPolynomial divide_exactly(RationalPolynomial dividend, const RationalPolynomial& divisor) {
  RationalPolynomial quotient;
  while (dividend.size() >= divisor.size()) {
    const std::size_t shift = dividend.size() - divisor.size();
    const Rational factor = dividend.back() / divisor.back();
    if (quotient.empty()) quotient.resize(shift + 1);
    quotient[shift] = factor;
    for (std::size_t i = 0; i < divisor.size(); ++i) dividend[shift + i] -= factor * divisor[i];
    trim(dividend);
  }
  if (!dividend.empty()) throw std::logic_error("polynomial division with a remainder");
  return quotient;
}

RationalPolynomial minimal_polynomial(int n) {
  static thread_local std::map<int, RationalPolynomial> known;
  if (const auto found = known.find(n); found != known.end()) return found->second;
  const int s = n / 2;
  RationalPolynomial result = n == 1 ? RationalPolynomial{Rational(-2), Rational(1)}
                              : n % 2 == 0 ? minus(chebyshev(s + 1), chebyshev(s - 1))
                                           : minus(chebyshev(s + 1), chebyshev(s));
  for (int d = 1; d < n; ++d)
    if (n % d == 0) result = divide_exactly(result, minimal_polynomial(d));
  return known[n] = result;
}

}  // namespace asts::reference
