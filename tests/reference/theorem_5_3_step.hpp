#pragma once

#include "tests/reference/suitability.hpp"

/// What the proof of Theorem 5.3 looks at, for the statements and for the witnesses against them.
namespace asts::reference {

using Nodes = std::vector<PointIn<Grid>>;
using Boxes = std::vector<BasicBox<Grid>>;

/// One mesh: its space and splines.
struct Side {
  Space<Grid> space;
  std::vector<ActiveNode<Grid>> splines;

  /// REQUIRES: all index vectors exist.
  Side(const Setting& setting, const Mesh& mesh, Grid scale);
};

/// G and G^ = subdiv(G, K), in units of 1/scale. Coordinates of the mesh are even (see grid_scale).
struct Step {
  Setting setting;
  Grid scale;
  Side before, after;
  BasicBox<Grid> k;
  std::size_t x, y, z;   ///< the axes in the proof's roles: K is subdivided along x; the next two, cyclically
  std::vector<Grid> xi;  ///< Xi~
  Nodes created;         ///< N^_A \ N_A
};

/// REQUIRES: K, the element at the position, has a level; all index vectors exist; 64 bits hold the grid.
Step make_step(const Setting& setting, const Mesh& mesh, std::size_t element);

/// R_axis(q) of one of the meshes, as a union of closed rectangles.
Boxes slice_region(const Side& side, std::size_t axis, Grid q);

bool any_contains(const Boxes& boxes, const PointIn<Grid>& point);

/// Is the union of the first boxes a subset of the union of the second ones?
bool subset(const Boxes& first, const Boxes& second);

/// The slice S_x(xi) cut with the supports, in the hatted mesh, of the nodes of a list.
Boxes cut_supports(const Step& step, Grid xi, const Nodes& nodes);

/// N_x(xi).
Nodes slice_nodes(const Step& step, const Side& side, Grid xi);

/// P: the old active nodes with (v_2, v_3) in [y, y+y~] x [z, z+z~].
Nodes projected_nodes(const Step& step);

/// The first nodes that are not among the others.
Nodes minus(const Nodes& all, const Nodes& without);

}  // namespace asts::reference
