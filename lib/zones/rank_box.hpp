#pragma once

#include <algorithm>

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// A closed box between lines of a refinement tree, by the ranks of the tree's lines (which are more than a mesh's).
struct RankBox {
  PerAxis<RankInterval> side;

  RankInterval& operator[](Axis axis) { return side[at(axis)]; }
  const RankInterval& operator[](Axis axis) const { return side[at(axis)]; }
};

inline RankBox box_of(const RefinementTree& tree, std::int32_t id) {
  RankBox box;
  for (Axis axis = 0; axis < kDimension; ++axis) box[axis] = tree.extent(id, axis);
  return box;
}

/// The active region (Definition 4.1) along an axis, by ranks; lower > upper when it is empty. Line i is the integer i.
/// REQUIRES: up-to-date ranks.
RankInterval active_range(const RefinementTree& tree, Axis axis);
bool active_region_is_empty(const RefinementTree& tree);

/// Whether two closed intervals, or boxes, have a point in common.
inline bool touch(const RankInterval& one, const RankInterval& other) {
  return one.lower <= other.upper && other.lower <= one.upper;
}
inline bool touch(const RankBox& one, const RankBox& other) {
  return std::equal(one.side.begin(), one.side.end(), other.side.begin(),
                    [](const RankInterval& a, const RankInterval& b) { return touch(a, b); });
}

/// Whether a box lies in the interior of another one: then nothing outside the other touches it.
inline bool inside(const RankBox& inner, const RankBox& outer) {
  return std::equal(
      inner.side.begin(), inner.side.end(), outer.side.begin(),
      [](const RankInterval& a, const RankInterval& b) { return a.lower > b.lower && a.upper < b.upper; });
}

/// The least box that contains two.
inline RankBox hull(RankBox one, const RankBox& other) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    one[axis].lower = std::min(one[axis].lower, other[axis].lower);
    one[axis].upper = std::max(one[axis].upper, other[axis].upper);
  }
  return one;
}

/// How much is worked on at a time. Results do not depend on it.
struct ZoneLimits {
  /// Of a new zone at most, and up to four times as many where the mesh has 64 such zones: what a zone shares with its
  /// neighbours counts for less in a larger one. A zone that follows a step is divided down to a quarter as many nodes.
  std::int32_t elements = 4096;
  /// Of a zone's window, and of a box in which violations are looked for, along one axis; from 3 to 64.
  std::size_t lines = 64;
};

}  // namespace asts
