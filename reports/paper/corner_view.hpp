#pragma once

#include <functional>
#include <string>

#include "lib/mesh/refinement_tree.hpp"
#include "properties/witness.hpp"
#include "reports/slices/svg.hpp"

namespace asts {

/// A parallel view of the index domain from below its corner at the origin's side: the origin is the lowest point in
/// the middle, x runs to the right and back, y to the left and back, z up. The sides x = 0, y = 0 and z = Z~ are seen,
/// so that what happens at the "lower left front corner" is. Axes are projected by rational numbers: a step of x is
/// 13/15 to the right and 1/2 up, a step of z is 1 up.
struct CornerView {
  PerAxis<int> domain;
  Rational scale;  ///< pixels a unit of z
  Px left;
  Px top;

  std::array<Px, 2> place(const ExactPoint& point) const;
  Px width() const;
  Px height() const;
  Px middle() const { return left + width() / 2; }
};

/// Whether a side orthogonal to the axis is seen from outside at its upper end: z alone.
constexpr bool seen_above(Axis axis) { return axis == 2; }

/// The rectangle of a box's shadow on the plane orthogonal to an axis at a position, as the data of an SVG path.
std::string face_path(const CornerView& view, Axis axis, const Rational& position, const ExactBox& box);

/// What colour a leaf of the tree has.
using Paint = std::function<std::string(std::int32_t leaf)>;

/// The three sides of the domain with the faces of the leaves there.
void draw_surface(XmlNode parent, const CornerView& view, const RefinementTree& tree, const Paint& paint);

/// The three sides of a box that are seen.
void draw_box(XmlNode parent, const CornerView& view, const ExactBox& box, const std::string& colour);
/// The edges of these sides alone.
void draw_box_edges(XmlNode parent, const CornerView& view, const ExactBox& box, const char* css_class);

/// Names beside the domain's axes.
void name_axes(XmlNode parent, const CornerView& view);

/// A grey for a level out of 0 to `highest`, dark for high ones.
std::string grey_of(std::int32_t level, std::int32_t highest);

}  // namespace asts
