#pragma once

#include "lib/exact/cube_root_field.hpp"
#include "properties/claims/claim.hpp"
#include "properties/claims/marked_sequence.hpp"

namespace asts {

/// The two sums in the proof of Theorem 7.1, for the whole sequence: over the marks K~ at least 1 for each new K, over
/// the new K at most C for each mark. `met` grows by the pairs with lambda(K,K~) > 0 and a mark of level >= 1.
/// `reach` is the vector 2 (d_1, d_2, d_3) of the definition of lambda.
std::optional<ClaimWitness> judge_lambda_sums(const MarkedSequence& sequence, const PerAxis<CubeRootNumber>& reach,
                                              const CubeRootNumber& constant, std::int64_t& met);

/// A sequence with meshes of more elements is not built; see judge_outer_children.
inline constexpr std::int64_t kMostListedElements = 200'000;
/// So many pairs of a new element and a mark are looked at then.
inline constexpr std::int64_t kMostNarrowPairs = 1'000'000;

/// The first sum alone, for new elements that are the first or last child of another one, which are the farthest of its
/// children from any mark outside it. Lowest levels first, until kMostNarrowPairs pairs have been looked at. Finding
/// nothing decides nothing.
std::optional<ClaimWitness> judge_outer_children(const NarrowSequence& sequence, const PerAxis<CubeRootNumber>& reach,
                                                 std::int64_t& met);

Trial lambda_sums_on_sequence(const Case& sequence);
Trial lambda_sums_repaired_on_sequence(const Case& sequence);

}  // namespace asts
