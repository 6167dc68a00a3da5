#include "tests/reference/grid.hpp"

#include <algorithm>
#include <stdexcept>

namespace asts::reference {

namespace {

void include_denominator(const Rational& value, Integer& common) {
  const mpz_srcptr denominator = mpq_denref(value.backend().data());
  if (mpz_divisible_p(common.backend().data(), denominator)) return;
  mpz_lcm(common.backend().data(), common.backend().data(), denominator);
}

}  // namespace

std::optional<Grid> grid_scale(const Setting& setting, const Mesh& mesh) {
  const Integer limit = Integer(1) << 62;
  const int largest = std::max({setting.domain[0], setting.domain[1], setting.domain[2]});
  Integer common = 1;
  for (const Box& box : mesh)
    for (std::size_t a = 0; a < dimension; ++a) {
      include_denominator(box.lower[a], common);
      include_denominator(box.upper[a], common);
      if (common * 2 * (largest + 1) >= limit) return std::nullopt;
    }
  return static_cast<Grid>(common * 2);
}

Grid on_grid(const Rational& value, Grid scale) {
  const mpz_srcptr top = mpq_numref(value.backend().data()), bottom = mpq_denref(value.backend().data());
  if (!mpz_fits_slong_p(top) || !mpz_fits_slong_p(bottom)) throw std::logic_error("coordinate too large for the grid");
  const Grid numerator = mpz_get_si(top), denominator = mpz_get_si(bottom);
  Grid result = 0;
  if (scale % denominator != 0 || __builtin_mul_overflow(numerator, scale / denominator, &result))
    throw std::logic_error("coordinate is not on the grid");
  return result;
}

template <>
BasicBox<Rational> in_units(const Box& box, Grid) {
  return {box.lower, box.upper};
}

template <>
BasicBox<Grid> in_units(const Box& box, Grid scale) {
  BasicBox<Grid> result{};
  for (std::size_t a = 0; a < dimension; ++a) {
    result.lower[a] = on_grid(box.lower[a], scale);
    result.upper[a] = on_grid(box.upper[a], scale);
  }
  return result;
}

}  // namespace asts::reference
