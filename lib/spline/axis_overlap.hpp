#pragma once

#include <cstdint>
#include <vector>

#include "lib/mesh/pair_table.hpp"
#include "lib/spline/bricks.hpp"

namespace asts {

/// Whether the index vectors of two bricks overlap (Equation (6.1)) along an axis, all of one with all of the other.
///
/// They do exactly if the bricks' entries agree in the closed range that both supports have in common. If a coordinate
/// q of that range is an entry of B alone, then some node of B has q in its vector, some node of B' has q in the range
/// of its vector, and these two do not overlap. If the entries agree there, and q in the vector of a node v of B lies
/// in the range of the vector of a node w of B', then q is an entry of B', and since w's vector is a window of
/// consecutive entries of B', q is an entry of it. In the first case the two nodes' supports have more than a point in
/// common along the axis: q is inside the range of w's vector without being an entry of it, so not at its end.
class AxisOverlap {
 public:
  /// REQUIRES: `bricks` outlives it.
  AxisOverlap(const Bricks& bricks, Axis axis) : bricks_(bricks), axis_(axis) {}

  bool holds(const Brick& one, const Brick& other);

 private:
  const Bricks& bricks_;
  Axis axis_;
  PairTable<bool> known_;
};

/// The first index of a brick whose index vector has an entry; that whose vector's closed range contains a rank.
/// REQUIRES: there is one.
std::int32_t index_with_entry(const TSplines& splines, const AxisProfile& profile, Axis axis, std::int32_t entry);
std::int32_t index_around(const TSplines& splines, const AxisProfile& profile, Axis axis, std::int32_t rank);

/// The first pair of indices whose supports have more than a point in common along the axis; where there is none, a
/// pair with a common point. REQUIRES: there is one.
std::pair<std::int32_t, std::int32_t> indices_meeting(const TSplines& splines, const AxisProfile& one,
                                                      const AxisProfile& other, Axis axis);

}  // namespace asts
