#pragma once

#include "lib/spline/index_sets.hpp"

namespace asts {

/// Definition 4.1: the active region AR = prod [ceil(p/2), X~ - ceil(p/2)], closed. As half ranks of a mesh, so that
/// membership and clipping are comparisons of integers also where no line runs along the region's sides.
struct ActiveRegion {
  PerAxis<HalfRank> lower;
  PerAxis<HalfRank> upper;
  bool empty = false;  ///< some X~ < 2 ceil(p/2)

  bool contains(Axis axis, HalfRank position) const {
    return position >= lower[at(axis)] && position <= upper[at(axis)];
  }
};

/// REQUIRES: odd degrees, so that ceil(p/2) = (p+1)/2.
ActiveRegion active_region(const Mesh& mesh);

/// The closed index domain in the same form, for what is asked of it in place of the active region.
ActiveRegion whole_domain(const Mesh& mesh);

}  // namespace asts
