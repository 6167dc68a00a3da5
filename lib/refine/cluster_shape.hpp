#pragma once

#include <cstdint>
#include <vector>

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// An open box, by the ranks of its sides.
using RankBox = PerAxis<RankInterval>;

/// A set of at most 64 elements of one level below one node, the root, as the bits of a word: bit b is the element that
/// would have the number b among all elements of the level below the root, in the order of the tree.
struct Cluster {
  std::int32_t root;
  std::uint64_t members;
};

/// What the clusters of one level have in common: how far below the root the members are, and where each bit lies along
/// the axes. Law 4 of RefinementTree (children in the order of their coordinates) makes that the same for all roots.
class ClusterShape {
 public:
  static constexpr std::int32_t kMostHeight = 6;  ///< 2^6 = 64

  /// For elements of this level: as high as 64 bits allow (m^height <= 64), but no higher than the unit cubes.
  ClusterShape(int grading, std::int32_t level);

  std::int32_t level() const { return level_; }
  std::int32_t height() const { return height_; }

  /// The members that lie at the i-th place along an axis, 0 <= i < places(axis).
  std::uint64_t members_at(Axis axis, std::int32_t i) const { return at_place_[at(axis)][at(i)]; }
  std::int32_t places(Axis axis) const { return static_cast<std::int32_t>(at_place_[at(axis)].size()); }

  /// The window (AxisGrid) of the members at this place. REQUIRES: there is one.
  RankInterval window(const RefinementTree& tree, std::int32_t root, Axis axis, std::int32_t i) const;

  /// The bounding box of the environments of all members. REQUIRES: there is one.
  RankBox window(const RefinementTree& tree, const Cluster& cluster) const;

  /// The member that a bit stands for.
  std::int32_t member(const RefinementTree& tree, std::int32_t root, int bit) const;

 private:
  int grading_;
  std::int32_t level_;
  std::int32_t height_ = 0;
  PerAxis<std::vector<std::uint64_t>> at_place_;
};

}  // namespace asts
