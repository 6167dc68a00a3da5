#pragma once

#include <cstdint>
#include <vector>

#include "lib/spline/active_region.hpp"

namespace asts {

/// The active nodes (Definition 4.1): the vertices of elements that lie in the active region, without repetition, in
/// lexicographic order. `beside[v][o]` is the element in octant o of node v, for the octants in which an element has v
/// as a vertex, and -1 for the others (bit a of o: the element lies above v along axis a).
/// Cost: linear in the elements.
struct ActiveNodes {
  static constexpr std::size_t kOctants = std::size_t{1} << kDimension;
  using Beside = std::array<std::int32_t, kOctants>;

  std::vector<PerAxis<std::int32_t>> positions;
  std::vector<Beside> beside;
};

ActiveNodes active_nodes(const Mesh& mesh, const ActiveRegion& region);

/// Sorts nodes stably by one axis: a counting sort over the ranks. Cost: linear in nodes and lines of the axis.
void stable_sort_by_axis(const Mesh& mesh, const std::vector<PerAxis<std::int32_t>>& positions, Axis axis,
                         std::vector<std::int32_t>& order);

}  // namespace asts
