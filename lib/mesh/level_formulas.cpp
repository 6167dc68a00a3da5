#include "lib/mesh/level_formulas.hpp"

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

/// m^(-(k - k mod 3)/3) times `full`, divided by m along the first k mod 3 axes: the three cases of both formulas.
PerAxis<Rational> scaled_to_level(PerAxis<Rational> full, int grading, int level) {
  require(level >= 0, "a level is not negative");
  const Rational scale = grading_power(grading, -(level / kDimension));
  for (Axis axis = 0; axis < kDimension; ++axis) {
    full[at(axis)] *= scale;
    if (axis < level % kDimension) full[at(axis)] /= grading;
  }
  return full;
}

}  // namespace

Rational grading_power(int grading, int exponent) {
  Integer power;
  mpz_ui_pow_ui(power.backend().data(), static_cast<unsigned long>(grading),
                static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rational(1) / Rational(power) : Rational(power);
}

PerAxis<Rational> level_size(int grading, int level) { return scaled_to_level({1, 1, 1}, grading, level); }

PerAxis<Rational> level_radius(const PerAxis<int>& degree, int grading, int level) {
  PerAxis<Rational> full;
  for (std::size_t axis = 0; axis < kDimension; ++axis) full[axis] = degree[axis] + Rational(3) / 2;
  return scaled_to_level(std::move(full), grading, level);
}

}  // namespace asts
