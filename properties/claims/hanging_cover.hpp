#pragma once

#include "properties/claims/claim.hpp"

namespace asts {

/// R_x, R_y and R_z as boxes of half ranks; empty lists when there is no active node.
using PerturbedRegions = PerAxis<std::vector<Box>>;
PerturbedRegions perturbed_regions(MeshUnderTest& mesh);

/// Definition 5.1, end: every hanging node and every point of a hanging edge (lib/spline/hanging.hpp) lies in the union
/// of the perturbed regions. Met: hanging nodes and edges.
Trial judge_hanging_cover(const Mesh& mesh, const PerturbedRegions& regions);

/// The repaired form: let a node or an edge hang on K along x, at x = q. If K has an active vertex w with
/// (q,w2,w3) not in Xi_x, and the node, or an end of the edge, is active, then R_x(q) contains the node, or the edge as
/// far as it lies in the active region. Likewise for y and z. Met: the pairs of a hanging node or edge and such a K.
Trial judge_hanging_cover_repaired(const Mesh& mesh, const PerturbedRegions& regions);

Trial perturbed_cover_hanging(MeshUnderTest& mesh);
Trial perturbed_cover_hanging_repaired(MeshUnderTest& mesh);

}  // namespace asts
