#pragma once

#include <optional>

#include "lib/exact/rational.hpp"

namespace asts::reference {

/// a + b t + c t^2 with t = m^(1/3), the literal code's own way: its sign is found by closing in on t with rationals.
struct RootSum {
  int m;
  Rational a = 0, b = 0, c = 0;
};

RootSum operator+(const RootSum& x, const RootSum& y);
RootSum operator-(const RootSum& x, const RootSum& y);
RootSum operator*(const RootSum& x, const RootSum& y);
RootSum operator*(const RootSum& x, const Rational& y);

/// m^(k/3), k of either sign.
RootSum root_power(int m, int k);

/// 1/(1 - m^(-1/3)) = m^(1/3)/(m^(1/3) - 1) = (m + m^(1/3) + m^(2/3))/(m - 1). REQUIRES: m >= 2.
RootSum geometric_sum(int m);

/// The number where it is rational: where b = c = 0, or m is a cube.
std::optional<Rational> rational_value(const RootSum& x);

/// -1, 0 or 1.
int sign(const RootSum& x);

}  // namespace asts::reference
