#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "lib/spline/box_pairs.hpp"
#include "lib/spline/tsplines.hpp"

namespace asts {

/// Active nodes v_(ijk) whose index vectors are those of a tensor product: the vector along x depends on i alone, along
/// y on j alone, along z on k alone; and the supports along each axis overlap one by one, so that their union is a box.
/// In uniform parts of a mesh a brick has many nodes. Whatever is decided axis by axis for a pair of nodes (overlap, a
/// factor of lambda, a slice) is decided once for a pair of indices of two bricks, instead of once for each pair of
/// their nodes.
struct Brick {
  std::int32_t begin;             ///< of its nodes in Bricks::members
  PerAxis<std::int32_t> count;    ///< of indices along each axis
  Box support;                    ///< the union of the nodes' supports, in ranks
  PerAxis<std::int32_t> profile;  ///< into Bricks::profiles
};

/// What a brick looks like along one axis; equal ones are stored once.
struct AxisProfile {
  std::vector<std::int32_t> vector_ids;  ///< the index vector of each index, ascending
  /// The entries of all these vectors, ascending, each once. They are consecutive entries of one global index set,
  /// because the nodes of one line have the same one and their supports overlap; each vector is a window of them.
  std::vector<std::int32_t> entries;
};

struct Bricks {
  std::vector<Brick> bricks;          ///< in the order of their first nodes
  std::vector<std::int32_t> members;  ///< nodes; in a brick the x-index runs fastest
  PerAxis<std::vector<AxisProfile>> profiles;
  /// All pairs i < j of bricks whose closed supports meet, if only in a point; in no particular order.
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;

  std::int32_t node(const Brick& brick, const PerAxis<std::int32_t>& index) const;
  const AxisProfile& profile(const Brick& brick, Axis axis) const {
    return profiles[at(axis)][at(brick.profile[at(axis)])];
  }
};

/// Every active node is in exactly one brick. Cost: linear in nodes, and a search for pairs of meeting boxes.
/// Throws BudgetExhausted when there are more than `max_pairs` pairs. REQUIRES: all index vectors exist.
Bricks bricks_of(const TSplines& splines, std::size_t max_pairs = std::numeric_limits<std::size_t>::max());

/// Whether two closed intervals of ranks have more than a point in common.
inline bool interiors_meet(const RankInterval& one, const RankInterval& other) {
  return one.lower < other.upper && other.lower < one.upper;
}

/// Whether two boxes have positive volume in common.
bool interiors_meet(const Box& one, const Box& other);

}  // namespace asts
