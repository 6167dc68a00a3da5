#pragma once

#include <optional>
#include <vector>

#include "lib/exact/rational.hpp"
#include "lib/mesh/case.hpp"
#include "lib/minimize/path_case.hpp"

namespace asts {

/// Changes of an explicit mesh, each a candidate for a smaller one. All give boxes that tile the domain, in ascending
/// order.

/// The distinct coordinates of the boxes' lower and upper sides along an axis, ascending; the domain's sides are among
/// them.
std::vector<Rational> coordinates_of(const Case& boxes, Axis axis);

/// Coordinates along an axis by a non-decreasing function that keeps the domain's lower side: boxes that lose their
/// extent are gone, and the upper side's image is the domain's new one. `to` has the images of coordinates_of().
/// REQUIRES: the last image is a positive integer.
Case with_coordinates(const Case& boxes, Axis axis, const std::vector<Rational>& to);

/// The domain without `count` layers of unit length from `first` on: all between is collapsed.
Case boxes_without_layers(const Case& boxes, Axis axis, int first, int count);

/// Pairs of boxes that meet in a full face across `axis` become one box each: those with the common coordinate and with
/// one trace on the two other axes, or, when `along` is another axis, with any trace along that one (all layers of an
/// extruded mesh at once).
struct Merge {
  Axis axis;
  std::size_t box;  ///< the lower one
  std::optional<Axis> along;
};
Case merged(const Case& boxes, const Merge& merge);
/// All pairs at one coordinate.
Case merged_at(const Case& boxes, Axis axis, const Rational& coordinate);

/// The domain in a mirror, and with axis a of the result taken from axis order[a]: both are symmetries of all that is
/// said of explicit meshes but for what levels are for.
Case boxes_reflected(const Case& boxes, const PerAxis<bool>& axes);
Case boxes_permuted(const Case& boxes, const PerAxis<Axis>& order);

/// The coarsest mesh of subdivisions in which every element lies in one of the boxes; nothing when it needs a level
/// above `max_level`.
std::optional<PathCase> refined_to_class(const Case& boxes, std::int32_t max_level);

}  // namespace asts
