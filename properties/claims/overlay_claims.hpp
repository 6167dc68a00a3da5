#pragma once

#include "properties/claims/claim.hpp"
#include "properties/claims/mark_sets.hpp"

namespace asts {

/// A common refinement of two meshes of one setting; the overlay is the coarsest (lib/refine/overlay.hpp).
using CommonRefinement = std::function<RefinementTree(const RefinementTree& one, const RefinementTree& other)>;

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
