#include <array>

#include "properties/claims/claim.hpp"
#include "properties/claims/hanging_cover.hpp"
#include "properties/claims/index_entries.hpp"
#include "properties/claims/planar_suitability.hpp"
#include "properties/claims/proof_figure.hpp"
#include "properties/claims/slice_figures.hpp"
#include "properties/claims/uniform_mesh.hpp"

namespace asts {

std::span<const Claim> skeleton_claims() {
  static constexpr std::array kClaims{
      Claim{.id = "frame-in-index-sets",
            .source = "Definition 4.3, note",
            .statement = "in an admissible mesh, the entries {0, ..., ceil(p1/2)-1, X~-ceil(p1/2)+1, ..., X~} are "
                         "always included in X(y,z), for every (y,z) of the closed domain; likewise Y(x,z) and Z(x,y)",
            .kind = ClaimKind::remark,
            .meshes = "a",
            .met_means = "cells across an axis whose index set has more than the integers",
            .refuted = true,
            .on_mesh = frame_in_index_sets},
      Claim{.id = "frame-in-index-sets-repaired",
            .source = "Definition 4.3, note, repaired",
            .statement = "in a mesh made by subdivisions, the entries {0, ..., ceil(p1/2)-1, X~-ceil(p1/2)+1, ..., X~} "
                         "are included in X(y,z), for every (y,z) of the closed domain, if X~ >= ceil(p1/2)-1; "
                         "likewise Y(x,z) and Z(x,y)",
            .kind = ClaimKind::remark,
            .meshes = "ar",
            .met_means = "cells across an axis whose index set has more than the integers",
            .on_mesh = frame_in_index_sets_repaired},
      Claim{.id = "index-vectors-exist",
            .source = "Definition 4.4",
            .statement = "for each active node v there are unique p1+2 consecutive elements in X(v2,v3) having v1 as "
                         "their (p1+3)/2-th (the middle) entry; likewise for y and z",
            .kind = ClaimKind::definition,
            .meshes = "ar",
            .met_means = "index vectors of active nodes that are not p+2 consecutive integers",
            .on_mesh = index_vectors_exist},
      Claim{.id = "uniform-unperturbed",
            .source = "Definition 5.1, end",
            .statement = "in a uniform mesh, the perturbed regions Rx, Ry, Rz are empty",
            .kind = ClaimKind::remark,
            .meshes = "ar",
            .met_means = "slices of uniform meshes inside the active region that hold active nodes",
            .on_mesh = uniform_unperturbed,
            .alone = uniform_unperturbed_alone},
      Claim{.id = "perturbed-cover-hanging",
            .source = "Definition 5.1, end",
            .statement =
                "in a non-uniform mesh, Rx, Ry and Rz together are a superset of all hanging nodes (nodes in a "
                "closed element that are no vertices of it) and edges (edges that meet the relative interior "
                "of an element's face)",
            .kind = ClaimKind::remark,
            .meshes = "ar",
            .met_means = "hanging nodes and edges",
            .refuted = true,
            .on_mesh = perturbed_cover_hanging,
            .stride = 2},
      Claim{.id = "perturbed-cover-hanging-repaired",
            .source = "Definition 5.1, end, repaired",
            .statement = "in an admissible mesh, let an active node h, or an edge with an active end, hang along x, at "
                         "x = q, on an element with an active vertex w with (q,w2,w3) not in Xi_x; then Rx(q) contains "
                         "h, or the edge's part in AR; likewise for y and z",
            .kind = ClaimKind::remark,
            .meshes = "a",
            .met_means = "pairs of a hanging node or edge and an element and axis as said",
            .on_mesh = perturbed_cover_hanging_repaired,
            .stride = 2},
      Claim{.id = "planar-equals-classical",
            .source = "Definition 5.2, remark",
            .statement = "for planar refinements of the mesh of unit squares (extruded to boxes) in which no line ends "
                         "outside the interior of AR, Definition 5.2 is equivalent to: no horizontal T-junction "
                         "extension meets a vertical one",
            .kind = ClaimKind::remark,
            .meshes = "e",
            .met_means = "pairs of a horizontal and a vertical T-junction of one planar mesh",
            .refuted = true,
            .on_mesh = planar_equals_classical},
      Claim{.id = "planar-equals-classical-repaired",
            .source = "Definition 5.2, remark, repaired",
            .statement = "for planar refinements of the mesh of unit squares (extruded to boxes) in which no line ends "
                         "outside the interior of AR and no two T-junctions face each other across one element, "
                         "Definition 5.2 is equivalent to: no horizontal T-junction extension meets a vertical one",
            .kind = ClaimKind::remark,
            .meshes = "e",
            .met_means = "pairs of a horizontal and a vertical T-junction of one planar mesh",
            .on_mesh = planar_equals_classical_repaired,
            .alone = planar_equals_classical_repaired_alone},
      Claim{.id = "figure-slices",
            .source = "Figures after Definition 5.2",
            .statement =
                "in the two planar examples, p = 3, q = 3/2: Nx(q), NA without Nx(q), the unions of the supports "
                "of both, Rx(q), the classical extension at (3/2,2), and whether the mesh is "
                "analysis-suitable, are as drawn and as the captions say",
            .kind = ClaimKind::figure,
            .meshes = "e",
            .met_means = "nodes and sets compared",
            .alone = figure_slices_alone},
      Claim{.id = "figure-proof-levels",
            .source = "Figures in the proof of Theorem 5.3",
            .statement =
                "for m = 2 and level(K) = 3 there are odd degrees p2, p3 >= 3 for which the mesh with the drawn "
                "levels on the slice is admissible and has the drawn patch, second-order patch, Sigma, Rx, Ry "
                "and Rz",
            .kind = ClaimKind::figure,
            .meshes = "a",
            .met_means = "drawn items that fit some degrees",
            .refuted = true,
            .on_mesh = figure_proof_levels,
            .alone = figure_proof_levels_alone},
      Claim{.id = "figure-proof-levels-repaired",
            .source = "Figures in the proof of Theorem 5.3, repaired",
            .statement =
                "for m = 2, p = (3,3,3), K = [8,17/2] x [21/2,11] of level 3 on the slice: level >= 1, 2, 3 in "
                "[0,17] x [0,21], [4,13] x [4,17], [6,21/2] x [8,13]; patch [6,21/2] x [17/2,13]; second-order "
                "patch [4,25/2] x [6,15]; Sigma [7,19/2] x [19/2,12]; Rx is Sigma and, outside (1,16) x (1,20), "
                "a ring; Ry at y = 9/2, 11/2, ..., 25/2, z in [2,5] and [16,19]; Rz at z = 17/2, ..., 25/2, y in "
                "[5,13/2] and [10,23/2]",
            .kind = ClaimKind::figure,
            .meshes = "a",
            .met_means = "items that are as said",
            .on_mesh = figure_proof_levels_repaired,
            .alone = figure_proof_levels_repaired_alone},
  };
  return kClaims;
}

}  // namespace asts
