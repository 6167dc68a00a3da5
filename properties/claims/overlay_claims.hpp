#pragma once

#include "properties/claims/claim.hpp"
#include "properties/claims/mark_sets.hpp"

namespace asts {

/// A common refinement of two meshes of one setting; the overlay is the coarsest (lib/refine/overlay.hpp).
using CommonRefinement = std::function<RefinementTree(const RefinementTree& one, const RefinementTree& other)>;

// The paper expects both claims and leaves them open. They have short proofs. Let I(G) be the set of elements that were
// subdivided on the way to G: the inner elements of its tree. I(G1 (+) G2) is the union of I(G1) and I(G2).
//
// Admissible: let K be in I(G1), say. By the criterion of lib/refine/admissibility.hpp the elements of G1 that meet
// U(K) have level(K) or more; those of the overlay that meet U(K) lie in these, so their levels are no lower. The
// criterion holds for the overlay.
//
// Cardinality: each subdivision makes m - 1 elements more, so elements(G) = elements(G0) + (m - 1) |I(G)|, and
// elements(G1) + elements(G2) - elements(G1 (+) G2) - elements(G0) = (m - 1) |I(G1) and I(G2)| >= 0. The bound is
// sharp: equality holds exactly if no element was subdivided in both.

/// `overlay-admissible` for two meshes: their overlay is admissible. REQUIRES: both are, and have one setting.
/// Counts 1 if neither mesh refines the other.
Trial judge_overlay_admissible(const RefinementTree& one, const RefinementTree& other, const CommonRefinement& combine);

/// `overlay-cardinality` for two meshes: elements(G1 (+) G2) + elements(G0) <= elements(G1) + elements(G2), where G0 is
/// the initial mesh. REQUIRES: as above. Counts as above.
Trial judge_overlay_cardinality(const RefinementTree& one, const RefinementTree& other,
                                const CommonRefinement& combine);

/// Both claims for two meshes with the program's own overlay: the second one's verdict only where the first one holds.
Trial overlay_trial(const RefinementTree& one, const RefinementTree& other);

/// Meshes of the same setting that are admissible if G is: its mirror images, and one that is refined in the corner far
/// from the origin, to G's highest level or to as many elements.
std::vector<RefinementTree> overlay_partners(const RefinementTree& tree);

Trial try_overlay_admissible(MeshUnderTest& mesh);
Trial try_overlay_cardinality(MeshUnderTest& mesh);

}  // namespace asts
