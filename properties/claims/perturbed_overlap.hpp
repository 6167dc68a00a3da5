#pragma once

#include "properties/claims/claim.hpp"
#include "properties/claims/slice_nodes.hpp"

namespace asts {

/// Lemma 6.5 for all three axes: where a slice S_x(q) meets the supports of v_1 in N_x(q) and v_2 not in N_x(q),
/// xx(v_1) and xx(v_2) do not overlap. Slices where no line runs have empty N_x(q).
Trial judge_perturbed_means_no_overlap(MeshUnderTest& mesh, const SliceNodes& slice_nodes);
Trial perturbed_means_no_overlap(MeshUnderTest& mesh);

}  // namespace asts
