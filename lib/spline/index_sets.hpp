#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/mesh/mesh.hpp"

namespace asts {

/// A position across an axis, on the mesh's lines or between them: 2*rank on a line, 2*rank+1 between a line and the
/// next one. Order and equality of coordinates become those of integers.
using HalfRank = std::int32_t;

/// The half rank of any coordinate of the domain. Cost: logarithmic in the axis's lines.
HalfRank half_rank(const Mesh& mesh, Axis axis, const Rational& coordinate);

/// Walks along a line parallel to an axis and lists where the skeleton orthogonal to the axis crosses it, from the
/// elements around the line alone.
///
/// Definition 4.2: Xi_x is the union of the closed x-orthogonal faces. Definition 4.3: X(y,z) = {x : (x,y,z) in Xi_x}.
/// A closed face of K contains (x,y,z) exactly if x is an end of K and (y,z) lies in the closed rectangle of K, so only
/// the elements that touch the line matter. Just off the line there are up to four of them at a time, one in each
/// quadrant: two where the line lies in a plane of lines of one other axis only, one where it lies in no such plane.
/// The next entry in a direction is the nearest end of these.
class LineWalker {
 public:
  /// Stands on the line through `position` (its own axis's entry is ignored) at a rank of the axis, looking up or down.
  /// REQUIRES: the position lies in the domain.
  LineWalker(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& position);

  /// Whether the skeleton crosses the line at a rank. Cost: up to eight searches.
  bool crosses(std::int32_t rank) const;

  /// The next entry above, or below, a rank; -1 at the end of the domain. The rank need not be an entry.
  std::int32_t next(std::int32_t rank, int direction) const;

 private:
  std::int32_t element_beside(std::size_t quadrant, std::int32_t interval) const;

  const Mesh& mesh_;
  std::size_t axis_;
  std::int32_t last_rank_;
  std::vector<PerAxis<std::int32_t>> quadrants_;  ///< the cells beside the line; the axis's own entry is free
};

/// Definition 4.3: the global index set along an axis through a point, as ascending ranks.
std::vector<std::int32_t> global_index_set(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& position);

}  // namespace asts
