#pragma once

#include <string>

#include "reports/slices/slice_geometry.hpp"
#include "reports/slices/slice_marks.hpp"
#include "reports/slices/svg.hpp"

namespace asts {

/// Where index coordinates of the plane lie on the canvas: the first axis to the right, the second one up.
struct Frame {
  Rational scale;  ///< pixels a unit, the same on both axes
  PxBox plot;      ///< the domain

  Px x(const Rational& value) const { return plot.lower[0] + rounded_px(value * scale); }
  Px y(const Rational& value) const { return plot.upper[1] - rounded_px(value * scale); }
  PxBox box(const PlaneRectangle& r) const { return {{x(r.lower[0]), y(r.upper[1])}, {x(r.upper[0]), y(r.lower[1])}}; }
};

struct SliceDrawing {
  const SliceGeometry& geometry;
  const SliceMarks& marks;
  std::array<Axis, 2> axes;
  Frame frame;

  PlanePoint project(const ExactPoint& point) const { return {point[at(axes[0])], point[at(axes[1])]}; }
  PlaneRectangle project(const ExactBox& box) const { return {project(box.lower), project(box.upper)}; }
  bool in_plane(const ExactPoint& point) const { return point[at(geometry.slice.axis)] == geometry.slice.position; }
  bool in_plane(const ExactBox& box) const {
    const std::size_t a = at(geometry.slice.axis);
    return box.lower[a] <= geometry.slice.position && geometry.slice.position <= box.upper[a];
  }
};

/// The layers of the picture, the lowest first.
void draw_elements(XmlNode svg, const SliceDrawing& drawing);
void draw_regions(XmlNode svg, const SliceDrawing& drawing);
void draw_borders(XmlNode svg, const SliceDrawing& drawing);  ///< of the domain and the active region; active nodes
void name_regions(XmlNode svg, const SliceDrawing& drawing);  ///< beside their largest parts
void draw_marks(XmlNode svg, const SliceDrawing& drawing);    ///< nodes, supports, points, boxes

/// What each sign means, downwards from a place. Returns where it ends.
Px draw_legend(XmlNode svg, const SliceDrawing& drawing, Px x, Px y);

/// What is seen, in words and numbers.
std::string slice_title(const SliceGeometry& geometry);
std::string slice_description(const SliceGeometry& geometry, const SliceMarks& marks);

/// "(2, 5/2, 3)"
std::string point_text(const ExactPoint& point);

}  // namespace asts
