#pragma once

#include <span>

#include "properties/claims/claim.hpp"

namespace asts {

/// The remark to Definition 6.4. Partial overlap in the sense of Beirao da Veiga, Buffa, Sangalli, Vazquez, Definition
/// 7.1, of two different nodes: along some direction their index vectors differ and overlap.
///
/// Decided for every two different active nodes, whether or not their supports meet, because the remark is about the
/// definitions of partial overlap; the classes of meshes are then nested for any choice of pairs:
///  - overlap along two of three axes (Definition 6.3) implies the general definition;
///  - in a planar mesh, extruded along one axis to have elements, overlap along one of the two axes (Definition 6.3
///  with
///    all but one axis, as in two dimensions) and the general definition are the same for nodes of one plane.
///
/// Why: let two different nodes overlap along all axes but one. If their vectors differ along one of these, done. If
/// they agree there, so do the nodes' coordinates, the nodes stand on one line along the last axis, and their vectors
/// there are different windows of one index set: they differ and overlap.
///
/// `axes` are the directions that the general definition looks at in space.
Trial judge_weak_overlap(MeshUnderTest& mesh, std::span<const Axis> axes);
Trial dc_within_weak_dc(MeshUnderTest& mesh);

/// The axis along which a mesh is a planar mesh times an interval's partition, if there is one.
std::optional<Axis> extrusion_axis(const Mesh& mesh);

}  // namespace asts
