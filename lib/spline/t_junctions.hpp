#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "lib/mesh/mesh.hpp"

namespace asts {

/// Analysis-suitability of planar T-meshes in its classical form, by T-junction extensions: Li, Zheng, Sederberg,
/// Hughes, Scott, "On linear independence of T-spline blending functions" (CAGD 29, 2012) for degree 3; Beirao da
/// Veiga, Buffa, Sangalli, Vazquez, "Analysis-suitable T-splines of arbitrary degree" (M3AS 23, 2013). For odd degrees:
///
/// A T-junction is an inner vertex of valence three. It is horizontal if the missing edge is (then a horizontal line
/// ends there), else vertical. Let (i,j) be a horizontal T-junction and hI(j) = {i' : (i',j) on a vertical edge,
/// closed}. Its extension is the closed horizontal segment from the (p1-1)/2-th entry of hI(j) before i, on the side of
/// the line that ends (the edge extension), to the (p1+1)/2-th entry behind i, on the side of the missing edge (the
/// face extension). Vertical ones: the same with x and y exchanged. The mesh is analysis-suitable if no horizontal
/// extension meets a vertical one.
///
/// The definition is made for T-meshes of a class that both papers assume:
///   (a) lines do not end in the frame: the frame's lines run through it, and all T-junctions lie in the interior of
///       the active region; so an extension has all its entries;
///   (b) no two T-junctions face each other across one element: in the first paper it is the rule of Sederberg et al.
///       (2003) that then the edge between them must be there; in the second (class AD+) that the open segment between
///       two vertices on one element's boundary, on one line, lies in the boundary.

/// Lines are numbered by ranks; axis 0 is horizontal.
struct PlanarBox {
  std::array<std::int32_t, 2> lower;
  std::array<std::int32_t, 2> upper;

  friend auto operator<=>(const PlanarBox&, const PlanarBox&) = default;
};

/// Which edges there are between neighbouring crossings of the lines of a planar mesh of boxes.
class PlanarEdges {
 public:
  PlanarEdges(std::array<std::int32_t, 2> lines, const std::vector<PlanarBox>& boxes);

  std::int32_t lines(std::size_t axis) const { return lines_[axis]; }
  /// Is there an edge from a crossing to the next one in direction +1 or -1 along an axis?
  bool edge(const std::array<std::int32_t, 2>& crossing, std::size_t axis, int direction) const;
  /// Is the crossing on an edge across the axis, closed? Then its coordinate is in hI (axis 0) or vI (axis 1).
  bool crosses(const std::array<std::int32_t, 2>& crossing, std::size_t axis) const {
    return edge(crossing, 1 - axis, +1) || edge(crossing, 1 - axis, -1);
  }

 private:
  std::size_t place(const std::array<std::int32_t, 2>& crossing) const {
    return at(crossing[0]) * at(lines_[1]) + at(crossing[1]);
  }

  std::array<std::int32_t, 2> lines_;
  std::array<std::vector<bool>, 2> edges_;  ///< by axis: from the crossing upwards along it
};

struct TJunction {
  std::array<std::int32_t, 2> position;
  std::size_t axis;  ///< 0: horizontal
  int direction;     ///< of the missing edge: +1 or -1

  friend bool operator==(const TJunction&, const TJunction&) = default;
};

/// A closed segment along an axis.
struct Extension {
  TJunction junction;
  std::int32_t lower;
  std::int32_t upper;

  std::int32_t line() const { return junction.position[1 - junction.axis]; }
};

/// Ascending by position.
std::vector<TJunction> t_junctions(const PlanarEdges& edges);

/// Extensions end at the domain's border where entries run out. REQUIRES: odd degree.
Extension extension(const PlanarEdges& edges, const TJunction& junction, int degree);

/// A horizontal and a vertical extension that meet, if there are any. Degrees of the two axes.
std::optional<std::pair<Extension, Extension>> crossing_extensions(const PlanarEdges& edges,
                                                                   const std::array<int, 2>& degree);

/// Two T-junctions that face each other: nothing but one element lies between them.
std::optional<std::pair<TJunction, TJunction>> facing_junctions(const PlanarEdges& edges);

/// The boxes of one layer when the mesh is a planar mesh times the intervals between the lines of an axis; ascending.
/// The first of the other two axes, in their order, is horizontal.
std::optional<std::vector<PlanarBox>> planar_boxes(const Mesh& mesh, Axis extruded);

/// The axes of a planar mesh, in order.
constexpr std::array<Axis, 2> planar_axes(Axis extruded) { return {extruded == 0 ? 1 : 0, extruded == 2 ? 1 : 2}; }

}  // namespace asts
