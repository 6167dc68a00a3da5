#pragma once

#include "lib/exact/cube_root_field.hpp"
#include "properties/claims/claim.hpp"
#include "properties/claims/marked_sequence.hpp"

namespace asts {

/// Theorem 7.1 for every part G_0, ..., G_j of a sequence: new elements <= C * marks.
std::optional<ClaimWitness> judge_complexity(const MarkedSequence& sequence, const CubeRootNumber& constant);

/// The two sums in the proof of Theorem 7.1, for the whole sequence: over the marks K~ at least 1 for each new K, over
/// the new K at most C for each mark. `met` grows by the pairs with lambda(K,K~) > 0 and a mark of level >= 1.
/// `reach` is the vector 2 (d_1, d_2, d_3) of the definition of lambda.
std::optional<ClaimWitness> judge_lambda_sums(const MarkedSequence& sequence, const PerAxis<CubeRootNumber>& reach,
                                              const CubeRootNumber& constant, std::int64_t& met);

Trial complexity_bound_on_sequence(const Case& sequence);
Trial lambda_sums_on_sequence(const Case& sequence);

}  // namespace asts
