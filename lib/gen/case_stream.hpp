#pragma once

#include <cstdint>

#include "lib/gen/random_case.hpp"

namespace asts {

/// A case of the stream before it is made: where most of the work can still be left out.
struct PlannedCase {
  Draw draw;
  CaseLimits limits;
  Bias bias;
  Setting setting;
};

/// The random cases that claims are tried on: number `number` of the stream of a seed. All biases with the same
/// probability, sizes mixed: most cases are small, so that many of them can be tried; one in five has m up to 16, one
/// in ten degrees up to 9 on one axis, one in forty on each, one in ten more elements and steps. Every case has a
/// generator state of its own, so that cases can be left out, or made by several programs, without changing the others.
PlannedCase plan_case(std::uint64_t seed, std::int64_t number);
RandomCase make_case(PlannedCase planned);

}  // namespace asts
