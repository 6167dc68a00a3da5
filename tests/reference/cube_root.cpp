#include "tests/reference/cube_root.hpp"

#include "tests/reference/mesh.hpp"

namespace asts::reference {

RootSum operator+(const RootSum& x, const RootSum& y) { return {x.m, x.a + y.a, x.b + y.b, x.c + y.c}; }

RootSum operator-(const RootSum& x, const RootSum& y) { return {x.m, x.a - y.a, x.b - y.b, x.c - y.c}; }

RootSum operator*(const RootSum& x, const RootSum& y) {
  const Rational a = x.a * y.a + x.m * (x.b * y.c + x.c * y.b);
  const Rational b = x.a * y.b + x.b * y.a + x.m * x.c * y.c;
  return {x.m, a, b, x.a * y.c + x.b * y.b + x.c * y.a};
}

RootSum operator*(const RootSum& x, const Rational& y) { return {x.m, x.a * y, x.b * y, x.c * y}; }

RootSum root_power(int m, int k) {
  int whole = 0;
  for (; k < 0; k += 3) --whole;
  for (; k > 2; k -= 3) ++whole;
  RootSum result{m};
  (k == 0 ? result.a : k == 1 ? result.b : result.c) = power(m, whole);
  return result;
}

RootSum geometric_sum(int m) {
  const Rational share = Rational(1) / (m - 1);
  return {m, m * share, share, share};
}

std::optional<Rational> rational_value(const RootSum& x) {
  if (x.b == 0 && x.c == 0) return x.a;
  for (int root = 1; root * root * root <= x.m; ++root)
    if (root * root * root == x.m) return x.a + x.b * root + x.c * root * root;
  return std::nullopt;
}

int sign(const RootSum& x) {
  if (const auto value = rational_value(x)) return value->sign();  // otherwise not 0: 1, t, t^2 are independent over Q
  Rational lower = 1, upper = x.m;                                 // 1 <= t <= m; halved until the sign is certain
  for (;;) {
    const auto at = [&](const Rational& b_root, const Rational& c_root) {
      return Rational(x.a + x.b * b_root + x.c * c_root * c_root);
    };
    const Rational least = at(x.b < 0 ? upper : lower, x.c < 0 ? upper : lower);
    const Rational greatest = at(x.b < 0 ? lower : upper, x.c < 0 ? lower : upper);
    if (least > 0) return 1;
    if (greatest < 0) return -1;
    const Rational middle = (lower + upper) / 2;
    (middle * middle * middle <= x.m ? lower : upper) = middle;
  }
}

}  // namespace asts::reference
