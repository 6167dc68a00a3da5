#pragma once

#include <optional>
#include <vector>

#include "lib/spline/t_junctions.hpp"
#include "properties/claims/claim.hpp"

namespace asts {

/// A planar mesh as a mesh of boxes extruded along an axis.
struct PlanarMesh {
  Axis extruded;
  std::vector<PlanarBox> boxes;
  PlanarEdges edges;
};

/// Nothing when the mesh is not planar. A mesh that is planar along several axes is a tensor product; then the first.
std::optional<PlanarMesh> planar_mesh(const Mesh& mesh);

/// Is the planar mesh a refinement of the initial mesh of unit squares: does each box lie in one of them?
bool refines_unit_squares(const Mesh& mesh, Axis extruded);

/// Do all T-junctions lie in the interior of the active region (condition (a) of lib/spline/t_junctions.hpp)?
bool lines_end_inside(const Mesh& mesh, const PlanarMesh& planar);

/// Definition 5.2 and the classical definition, with extensions for the given degrees, agree. Met: the pairs of a
/// horizontal and a vertical T-junction.
Trial judge_planar(MeshUnderTest& mesh, const PlanarMesh& planar, const std::array<int, 2>& extension_degree);

Trial planar_equals_classical(MeshUnderTest& mesh);
Trial planar_equals_classical_repaired(MeshUnderTest& mesh);

/// Random planar meshes of lib/gen/planar_tiling.hpp, and all those with halved squares in small active regions.
Trial planar_equals_classical_repaired_alone(Extent extent);

}  // namespace asts
