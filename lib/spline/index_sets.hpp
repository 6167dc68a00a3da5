#pragma once

#include <array>
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

/// Walks along a line parallel to an axis, in one direction, and lists where the skeleton orthogonal to the axis
/// crosses it, from the elements around the line alone.
///
/// Definition 4.2: Xi_x is the union of the closed x-orthogonal faces. Definition 4.3: X(y,z) = {x : (x,y,z) in Xi_x}.
/// A closed face of K contains (x,y,z) exactly if x is an end of K and (y,z) lies in the closed rectangle of K, so only
/// the elements that touch the line matter. Just off the line there are up to four of them at a time, one in each
/// quadrant: two where the line lies in a plane of lines of one other axis only, one where it lies in no such plane.
/// The next entry in the direction of the walk is the nearest end of these, and only the elements that end there are
/// replaced.
class LineWalker {
 public:
  static constexpr std::size_t kQuadrants = std::size_t{1} << (kDimension - 1);

  /// Stands on the line through `position`, at the rank that its own axis's half rank gives, which need not be an
  /// entry; direction is +1 or -1. REQUIRES: the position lies in the domain; its own axis's half rank is even.
  LineWalker(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& position, int direction);

  /// Spares a search: the element that the walk meets first in a quadrant. Bit k of the quadrant is set for the side
  /// below the line along the k-th of the other axes. REQUIRES: the line is in lines of both other axes, inside the
  /// domain; next() was not called yet.
  void enter(std::size_t quadrant, std::int32_t element) { ends_[quadrant] = end_of(element); }

  /// Goes on to the next entry; -1 at the end of the domain. Cost: a search in the mesh for each element that ended.
  std::int32_t next();

 private:
  void enter_elements();
  std::int32_t end_of(std::int32_t element) const;

  const Mesh& mesh_;
  std::size_t axis_;
  int direction_;
  std::int32_t rank_;
  std::size_t quadrants_ = 1;
  std::array<PerAxis<std::int32_t>, kQuadrants> cells_;  ///< beside the line; the axis's own entry follows the walk
  std::array<std::int32_t, kQuadrants> ends_;            ///< where each quadrant's element ends; the rank: not entered
};

/// Definition 4.3: the global index set along an axis through a point, as ascending ranks.
std::vector<std::int32_t> global_index_set(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& position);

}  // namespace asts
