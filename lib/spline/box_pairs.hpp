#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "lib/mesh/mesh.hpp"

namespace asts {

/// Called with the indices of two boxes that meet.
using BoxPair = std::function<void(std::int32_t, std::int32_t)>;

/// Calls `meet(i, j)` once for every unordered pair i != j of closed boxes that meet, if only in a point. The order of
/// the calls is unspecified. Integer coordinates, exact. Cost: O(n log^3 n + pairs) (CGAL::box_self_intersection_d).
void for_each_meeting_pair(std::span<const Box> boxes, const BoxPair& meet);

/// The same for pairs of one box of either list, i in `one` and j in `other`.
void for_each_meeting_pair(std::span<const Box> one, std::span<const Box> other, const BoxPair& meet);

}  // namespace asts
