#pragma once

#include <cstdint>

#include "lib/mesh/case.hpp"
#include "lib/mesh/setting.hpp"

namespace asts {

/// The workloads of the benchmarks, as cases of `refine` steps. Each ends with the first mesh that has at least
/// `elements` elements.
enum class Workload {
  corner,  ///< each step marks the element at the origin
  sphere,  ///< each step marks all leaves whose closed box meets the sphere around the domain's centre with radius a
           ///< quarter of the shortest side
};

/// Marks are written as the lower corners of the marked elements. Exact: a closed box meets the sphere if its least
/// distance to the centre is at most the radius and its greatest at least, compared as squares of rationals.
Case generate_workload(Workload workload, const Setting& setting, std::int64_t elements);

}  // namespace asts
