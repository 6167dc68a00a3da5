#include "lib/refine/complexity_constants.hpp"

namespace asts {

namespace {

CubeRootNumber root_power(int grading, Axis axis) { return cube_root_power(grading, axis); }

/// 1/(1 - m^(-1/3)).
CubeRootNumber geometric_sum(int grading) {
  const CubeRootNumber one(grading, 1);
  return one / (one - cube_root_power(grading, -1));
}

/// m^(axis/3)/(1 - m^(-1/3)) (p + (3 + m^(1/3))/2 + child).
PerAxis<CubeRootNumber> constants_with(const PerAxis<int>& degree, int grading, const CubeRootNumber& child) {
  const auto constant = [&](Axis axis) {
    const CubeRootNumber radius =
        (root_power(grading, 1) + Rational(3)) * (Rational(1) / 2) + Rational(degree[at(axis)]) + child;
    return root_power(grading, axis) * geometric_sum(grading) * radius;
  };
  return {constant(0), constant(1), constant(2)};
}

}  // namespace

PerAxis<CubeRootNumber> distance_constants(const PerAxis<int>& degree, int grading) {
  const Rational m = grading;
  return constants_with(degree, grading, (root_power(grading, 1) - Rational(1)) * (1 / (m * m)));
}

PerAxis<CubeRootNumber> corrected_distance_constants(const PerAxis<int>& degree, int grading) {
  const Rational m = grading;
  return constants_with(degree, grading, (root_power(grading, 1) - Rational(1)) * ((m - 1) / (2 * m)));
}

CubeRootNumber complexity_constant(const PerAxis<CubeRootNumber>& d) {
  const int m = d[0].m();
  CubeRootNumber result = root_power(m, 1) * geometric_sum(m);
  for (Axis axis = 0; axis < kDimension; ++axis) result *= d[at(axis)] * Rational(4) + root_power(m, axis);
  return result;
}

}  // namespace asts
