#pragma once

#include <cstdint>
#include <optional>

#include "lib/spline/bricks.hpp"

namespace asts {

/// A pair of active nodes, by their numbers in TSplines.
struct NodePair {
  std::int32_t v;
  std::int32_t w;

  friend auto operator<=>(const NodePair&, const NodePair&) = default;
};

/// Definition 6.4: a mesh is dual-compatible if any two active nodes whose supports' intersection has positive volume
/// partially overlap (Definition 6.3: their index vectors overlap along at least two of the three axes). Returns a pair
/// that does not, always the same for a mesh, or nothing if the mesh is dual-compatible.
///
/// Decided on pairs of bricks: two bricks have a pair of nodes that does not partially overlap, with supports that meet
/// in positive volume, exactly if the bricks' supports meet so and the bricks fail to overlap along two axes or three.
/// For the indices along the axes can be chosen independently of each other; where overlap fails along an axis, the two
/// indices that show it have supports with common interior there (AxisOverlap), and along an axis where nothing is
/// asked any pair with common interior will do. Nodes of one brick overlap along all axes. Cost: linear in the pairs of
/// bricks.
std::optional<NodePair> find_incompatible(const TSplines& splines, const Bricks& bricks);

/// The same with the pairs of nodes whose closed supports meet at all, if only in a point: a pair that does not
/// partially overlap, or nothing. Along an axis where overlap fails the supports have common interior, so that such a
/// pair of nodes touches along one axis at most.
std::optional<NodePair> find_incompatible_meeting(const TSplines& splines, const Bricks& bricks);

/// How many pairs of bricks have supports that share volume and fail to overlap along some axis: what Definition 6.4 is
/// about in a mesh that is not uniform.
std::int64_t count_overlap_failures(const Bricks& bricks);

}  // namespace asts
