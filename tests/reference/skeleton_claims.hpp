#pragma once

#include "tests/reference/suitability.hpp"

/// The claims of Sections 4 and 5 up to Definition 5.2, read from the paper alone and decided by brute force.
namespace asts::reference {

/// Definition 4.3's note along one axis: 0..ceil(p/2)-1 and X~-ceil(p/2)+1..X~ are in X(y,z) for all (y,z) that are
/// coordinates of the mesh or midpoints between two of them: X(y,z) is the same between two coordinates.
bool frame_entries_included(const Setting& setting, const Mesh& mesh, std::size_t axis);

/// Definition 4.4: around each active node there are p+2 consecutive entries on each axis with the node in the middle,
/// and only one choice of them.
bool index_vectors_unique(const Setting& setting, const Mesh& mesh);

/// Definition 5.1: all slice perturbations are empty.
bool unperturbed(const Setting& setting, const Mesh& mesh);

/// The nodes that lie in a closed element and are no vertex of it: one entry each.
std::vector<Point> hanging_nodes(const Mesh& mesh);
/// The edges of elements that meet the relative interior of an element's face: boxes without extent on two axes.
Mesh hanging_edges(const Mesh& mesh);

/// Is the point a vertex, or the segment an edge, of an element?
bool is_node_of(const Mesh& mesh, const Point& point);
bool is_edge_of(const Mesh& mesh, const Box& segment);
/// Does the node (a point) or edge hang on k: no vertex of it but in it; or meeting the relative interior of a face?
bool hangs_on(const Box& hanging, const Box& k);

/// All of them lie in the perturbed regions' union: tested at the nodes and, on edges, at all coordinates of the mesh
/// and between.
bool hanging_covered(const Setting& setting, const Mesh& mesh);

/// The repaired form, see the claim's statement. The mesh need not be admissible.
bool hanging_covered_if_vertex_outside(const Setting& setting, const Mesh& mesh);

/// A planar mesh: closed rectangles, and the classical definition on them (see lib/spline/t_junctions.hpp for the
/// sources), by brute force over coordinates.
struct Rectangle {
  std::array<Rational, 2> lower, upper;
};

/// The rectangles when the mesh is the same planar mesh in every layer between two coordinates of an axis.
std::optional<std::vector<Rectangle>> planar_rectangles(const Mesh& mesh, std::size_t axis);

struct PlanarJunction {
  std::array<Rational, 2> point;
  std::size_t axis;  ///< of the missing edge
  int direction;
};
std::vector<PlanarJunction> planar_junctions(const std::vector<Rectangle>& mesh);

/// The closed extension of a junction: (p+1)/2 entries on the side of the missing edge, (p-1)/2 on the other one.
Rectangle planar_extension(const std::vector<Rectangle>& mesh, const PlanarJunction& junction, int degree);
/// A horizontal and a vertical closed extension meet.
bool planar_extensions_meet(const std::vector<Rectangle>& mesh, std::array<int, 2> degree);
/// Two T-junctions on opposite sides of one rectangle, on one line across it.
bool planar_junctions_face(const std::vector<Rectangle>& mesh);

/// Definition 5.2; nothing when there is no active node or one lacks an index vector.
std::optional<bool> analysis_suitable(const Setting& setting, const Mesh& mesh);

}  // namespace asts::reference
