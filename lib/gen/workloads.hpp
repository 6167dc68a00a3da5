#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lib/mesh/case.hpp"
#include "lib/mesh/setting.hpp"

namespace asts {

/// The workloads of the benchmarks, as cases of `refine` steps. Each ends with the first mesh that has at least
/// `elements` elements.
enum class Workload {
  corner,  ///< each step marks the element at the origin
  sphere,  ///< each step marks all leaves whose closed box meets the sphere around the domain's centre with radius a
           ///< quarter of the shortest side
  random,  ///< each step draws ceil(n / 64) of the n leaves, each time any leaf with the same probability, from a fixed
           ///< seed, and marks those that were drawn, once each: refinement without a shape, spread over the domain
};

/// "corner", "sphere", "random": in this order.
std::span<const std::string_view> workload_names();

/// The workload of a name. Throws InputError if there is none.
Workload workload_named(std::string_view name);

/// Marks are written as the lower corners of the marked elements. Exact: a closed box meets the sphere if its least
/// distance to the centre is at most the radius and its greatest at least, compared as squares of rationals. Random
/// leaves are drawn as lib/gen/draw.hpp does, from the seed 1: the same arguments give the same case everywhere.
Case generate_workload(Workload workload, const Setting& setting, std::int64_t elements);

}  // namespace asts
