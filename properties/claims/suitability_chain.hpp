#pragma once

#include <optional>

#include "lib/spline/dual_compatibility.hpp"
#include "lib/spline/perturbed_regions.hpp"
#include "properties/claims/claim.hpp"

/// The chain of Figure 1 from analysis-suitability (Definition 5.2) by dual-compatibility (Definition 6.4) to the dual
/// basis (Theorem 6.7), each implication in two parts: a hypothesis that was decided, and the judgement.
namespace asts {

/// Where perturbed regions meet; nothing when they do not: the hypothesis of an implication.
using Meeting = std::optional<RegionsMeet>;
/// A pair of nodes that does not partially overlap; nothing when there is none: the hypothesis of an implication.
using Incompatible = std::optional<NodePair>;

/// The hypothesis of the repaired inclusion: the perturbed regions, with slices of the closed domain in place of slices
/// of the active region, do not meet.
Meeting find_meeting_in_whole_domain(MeshUnderTest& mesh);

/// AS within DC, for a hypothesis `meeting` of either kind.
Trial judge_as_implies_dc(MeshUnderTest& mesh, const Meeting& meeting);
/// The same, and that admissible meshes satisfy the hypothesis, so that the paper's main line stands.
Trial judge_as_implies_dc_repaired(MeshUnderTest& mesh, const Meeting& meeting);
/// DC within AS, for a hypothesis `incompatible` of either kind.
Trial judge_dc_implies_as(MeshUnderTest& mesh, const Incompatible& incompatible);
/// AS, as `meeting` says, implies the dual basis.
Trial judge_as_implies_dual_basis(MeshUnderTest& mesh, const Meeting& meeting);
/// Theorem 6.7.
Trial judge_dc_implies_dual_basis(MeshUnderTest& mesh, const Incompatible& incompatible);

Trial as_implies_dc(MeshUnderTest& mesh);
Trial as_implies_dc_repaired(MeshUnderTest& mesh);
Trial dc_implies_as(MeshUnderTest& mesh);
Trial dc_implies_as_repaired(MeshUnderTest& mesh);
Trial dc_implies_dual_basis(MeshUnderTest& mesh);
Trial as_implies_dual_basis(MeshUnderTest& mesh);
Trial as_implies_dual_basis_repaired(MeshUnderTest& mesh);

}  // namespace asts
