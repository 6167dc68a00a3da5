#include "lib/gen/case_stream.hpp"

#include <algorithm>

namespace asts {

namespace {

/// SplitMix64 (Steele, Lea, Flood 2014): neighbouring numbers give unrelated states.
std::uint64_t state_of(std::uint64_t seed, std::int64_t number) {
  std::uint64_t bits = seed * 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(number);
  for (int round = 0; round < 2; ++round) {
    bits += 0x9E3779B97F4A7C15ULL;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9ULL;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBULL;
    bits ^= bits >> 31;
  }
  return bits;
}

CaseLimits random_limits(Draw& draw) {
  CaseLimits limits{3, 5, 7, 125, 250, 5};
  if (draw.one_in(5)) limits.max_grading = 16;
  if (draw.one_in(40)) {
    limits.max_degree = 9;
    limits.max_cubes = 500;
  }
  if (draw.one_in(10)) {
    limits.max_elements = 1000;
    limits.max_steps = 10;
    limits.max_cubes *= 2;
  }
  return limits;
}

/// A higher degree on one axis, which then has its p+1 cubes at least, and the number of elements leaves room for it.
void raise_degree(Draw& draw, CaseLimits& limits, Setting& setting) {
  const std::size_t axis = draw.index(kDimension);
  const int cubes_more = setting.domain[axis] - setting.degree[axis];
  setting.degree[axis] = 3 + 2 * draw.between(1, 3);
  setting.domain[axis] = std::max(1, setting.degree[axis] + cubes_more);
  const std::int64_t cubes = std::int64_t{setting.domain[0]} * setting.domain[1] * setting.domain[2];
  limits.max_elements = std::max(limits.max_elements, cubes + 20 * (setting.grading - 1));
}

}  // namespace

PlannedCase plan_case(std::uint64_t seed, std::int64_t number) {
  PlannedCase planned{Draw(state_of(seed, number)), {}, Bias::marks_anywhere, {}};
  Draw& draw = planned.draw;
  planned.limits = random_limits(draw);
  planned.bias = all_biases()[draw.index(all_biases().size())];
  planned.setting = setting_for(draw, planned.limits, planned.bias);
  if (draw.one_in(10)) raise_degree(draw, planned.limits, planned.setting);
  return planned;
}

RandomCase make_case(PlannedCase planned) {
  return random_case_in(planned.draw, planned.setting, planned.limits, planned.bias);
}

}  // namespace asts
