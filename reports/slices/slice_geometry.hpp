#pragma once

#include <array>
#include <optional>
#include <vector>

#include "properties/mesh_under_test.hpp"

namespace asts {

/// The plane orthogonal to an axis at a position of the closed domain, in index coordinates.
struct Slice {
  Axis axis;
  Rational position;

  friend bool operator==(const Slice&, const Slice&) = default;
};

/// The other two axes, ascending: those of the plane.
std::array<Axis, 2> axes_in(const Slice& slice);

using PlanePoint = std::array<Rational, 2>;

/// A closed rectangle of a plane, in index coordinates of its two axes; it may be a segment or a point.
struct PlaneRectangle {
  PlanePoint lower;
  PlanePoint upper;

  friend bool operator==(const PlaneRectangle&, const PlaneRectangle&) = default;
};

/// A closed element's part of the plane, when it has area. A plane between mesh lines goes through elements; one that
/// has faces of elements has an element on either side there.
struct ElementTrace {
  enum class Side { through, lower, upper, both };  ///< both: two elements with this trace and this level
  PlaneRectangle trace;
  std::optional<std::int32_t> level;  ///< Definition 2.2, when it is an integer
  Side side;
};

/// What a plane cuts out of a mesh.
struct SliceGeometry {
  Slice slice;
  PlaneRectangle domain;
  std::optional<PlaneRectangle> active_region;  ///< projected along the slice's axis; nothing when empty
  bool in_active_region = false;                ///< whether the plane meets it
  std::int32_t highest_level = 0;               ///< of the whole mesh, so that its slices are shaded alike
  std::vector<ElementTrace> elements;           ///< by ascending level (none first), then by position
  std::vector<PlanePoint> active_nodes;         ///< those in the plane (Definition 4.1)
  /// Each perturbed region's part of the plane (Definition 5.1): rectangles for the region of the slice's own axis,
  /// segments or points for the others. Nothing where some index vector does not exist.
  std::optional<PerAxis<std::vector<PlaneRectangle>>> regions;
};

/// Throws InputError when the position is outside the domain, BudgetExhausted as MeshUnderTest::bricks() does.
/// Cost: that of the perturbed regions, once for a mesh; a walk over elements, nodes and regions; sorting what is cut.
SliceGeometry cut(MeshUnderTest& mesh, const Slice& slice);

}  // namespace asts
