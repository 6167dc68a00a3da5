#pragma once

#include "properties/claims/claim.hpp"
#include "properties/claims/closure_claims.hpp"

namespace asts {

/// `refine-admissible`: for every single mark and the sets of mark_sets(), the subdivision of the closure is admissible
/// (Definition 3.1: some order of it) and so is the mesh that it makes (Definition 3.2). Counts the single marks whose
/// closure has another element.
Trial judge_refine_admissible(const RefinementTree& tree, const ClosureOf& closure_of);

/// Algorithm 2.9 for one mark, in place. Brings the ranks up to date.
using RefineOne = std::function<void(RefinementTree& tree, std::int32_t mark)>;

/// `refine-generates-class`: makes the mesh from the initial one by calls of refine with one mark each, in the order of
/// levels, so that each call subdivides its mark alone. Counts the calls with a mark of level >= 1, for which there are
/// coarser elements to be in the way.
Trial judge_refine_generates(const RefinementTree& target, const RefineOne& refine_one);

/// `level-order-replay`: makes the mesh from the initial one by single subdivisions in the order of levels, and asks
/// Definition 3.1 each time. Counts the subdivisions of elements of level >= 1.
Trial judge_level_order(const RefinementTree& target, const InPatch& in_patch);

Trial try_refine_admissible(MeshUnderTest& mesh);
Trial try_refine_generates(MeshUnderTest& mesh);
Trial try_level_order(MeshUnderTest& mesh);

}  // namespace asts
