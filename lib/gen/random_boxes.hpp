#pragma once

#include <vector>

#include "lib/gen/draw.hpp"
#include "lib/mesh/case.hpp"
#include "lib/mesh/setting.hpp"

namespace asts {

/// A closed box with rational corners.
struct RationalBox {
  PerAxis<Rational> lower;
  PerAxis<Rational> upper;
};

/// A tiling of the domain by boxes that random operations change; it stays a tiling.
class BoxTiling {
 public:
  /// The unit cubes, or boxes between planes that are moved from the integers by less than 1/2: then no plane runs
  /// along the active region's sides, and each active node still has (p+1)/2 planes on either side, because a plane
  /// that came from i < (p+1)/2 is moved to less than (p+1)/2.
  BoxTiling(const Setting& setting, Draw& draw, bool move_planes);

  const std::vector<RationalBox>& boxes() const { return boxes_; }

  /// Cuts each box that has a common interior with the region and has q inside its extent along the axis.
  void cut(std::size_t axis, const Rational& q, const RationalBox& region);

  /// Replaces the boxes within the region by others that tile it; false and no change when a box crosses its border.
  bool replace(const RationalBox& region, const std::vector<RationalBox>& replacement);

 private:
  std::vector<RationalBox> boxes_;
};

/// A region whose sides are sides of boxes of the tiling: one box, mostly one that meets the active region, grown
/// upwards by up to `reach` units or so along each axis.
RationalBox random_region(Draw& draw, const BoxTiling& tiling, const Setting& setting, int reach);

/// Five boxes that tile the region and that no plane separates: around a middle one, extruded along an axis.
std::vector<RationalBox> pinwheel(Draw& draw, const RationalBox& region, std::size_t axis);

/// A number strictly between two others, with a small denominator relative to their distance.
Rational random_between(Draw& draw, const Rational& lower, const Rational& upper);

}  // namespace asts
