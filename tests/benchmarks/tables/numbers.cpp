#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/benchmarks/tables/tables.hpp"

namespace asts::benchmarks {

std::string three_digits(double value) {
  if (value == 0) return "0";
  const int before_point = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  return fmt::format("{:.{}f}", value, std::max(0, 3 - before_point));
}

std::string with_prefix(double value) {
  if (value >= 1e6) return three_digits(value / 1e6) + " M";
  if (value >= 1e4) return three_digits(value / 1e3) + " k";
  return three_digits(value);
}

}  // namespace asts::benchmarks
