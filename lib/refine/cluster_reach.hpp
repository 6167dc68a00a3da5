#pragma once

#include <array>
#include <cstdint>

#include "lib/refine/cluster_shape.hpp"

namespace asts {

/// Asked for an interval of an axis, finds all members of a cluster whose environments (Definition 2.4) reach into it
/// along the axis, with one comparison for each place that members have along it: elements with a common root have few
/// (for m = 2 at most 4 + 4 + 4 for 64 elements).
///
/// U(K) being the product of its sides, it meets the interior of a box exactly if it reaches into its side along each
/// axis. An element is the closure of its interior, so it meets the open box U(K) exactly if its interior does.
class ClusterReach {
 public:
  void assign(const RefinementTree& tree, const ClusterShape& shape, const Cluster& cluster) {
    for (Axis axis = 0; axis < kDimension; ++axis) {
      Side* side = sides_[at(axis)].data();
      for (std::int32_t i = 0; i < shape.places(axis); ++i) {
        const std::uint64_t members = shape.members_at(axis, i) & cluster.members;
        if (members != 0) *side++ = {shape.window(tree, cluster.root, axis, i), members};
      }
      last_[at(axis)] = side;
    }
  }

  std::uint64_t members_along(Axis axis, const RankInterval& interval) const {
    std::uint64_t members = 0;
    for (const Side* side = sides_[at(axis)].data(); side != last_[at(axis)]; ++side) {
      const bool meets = side->window.lower < interval.upper && interval.lower < side->window.upper;
      members |= meets ? side->members : 0;
    }
    return members;
  }

 private:
  struct Side {
    RankInterval window;
    std::uint64_t members;
  };

  PerAxis<std::array<Side, 64>> sides_;
  PerAxis<const Side*> last_;  ///< one past the last side in use
};

}  // namespace asts
