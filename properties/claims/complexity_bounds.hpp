#pragma once

#include "lib/exact/cube_root_field.hpp"
#include "properties/claims/claim.hpp"
#include "properties/claims/marked_sequence.hpp"

namespace asts {

/// Theorem 7.1 for every part G_0, ..., G_j of a sequence: new elements <= C * marks.
std::optional<ClaimWitness> judge_complexity(const MarkedSequence& sequence, const CubeRootNumber& constant);

Trial complexity_bound_on_sequence(const Case& sequence);

}  // namespace asts
