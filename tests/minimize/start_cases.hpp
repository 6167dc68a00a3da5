#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lib/mesh/case.hpp"

/// Start cases for the quality tests of the minimizer: large random cases that violate a claim or a property.
namespace asts {

/// The claims that are refuted, and what violating_explicit_start takes: claims and properties.
std::span<const std::string_view> start_claims();
std::span<const std::string_view> explicit_start_ids();

/// A case of steps that violates the claim, as different for different seeds as the claim allows.
/// Laws (tests/minimize/start_cases_test.cpp): (1) the claim is violated; (2) 10 or more elements are subdivided in the
/// last mesh (size_of); (3) no side of the domain is longer than 9, but for figure-proof-levels, which says nothing
/// about domains of less than 17 x 21 along y and z; (4) a seed gives one case, different seeds different ones.
/// Cost: some 10 ms for most; lambda-sums is made without deciding it, which takes a second, like deciding
/// distance-bound. Throws InputError when the claim has no starts.
Case violating_start(std::string_view claim, std::uint64_t seed);

/// The same as explicit boxes, some of them from subdivisions and some not, 10 or more beyond the initial cubes.
Case violating_explicit_start(std::string_view id, std::uint64_t seed);

}  // namespace asts
