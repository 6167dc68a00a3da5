#pragma once

#include "lib/exact/cube_root_field.hpp"
#include "properties/claims/family_facts.hpp"

namespace asts {

/// The equations of Appendix A about an element and its parent, each for one pair.

std::optional<ClaimWitness> judge_size(const ParentAndChild& family);                     ///< size-formula
std::optional<ClaimWitness> judge_child_distance(const ParentAndChild& family);           ///< child-distance
std::optional<ClaimWitness> judge_child_distance_repaired(const ParentAndChild& family);  ///< child-distance-repaired
std::optional<ClaimWitness> judge_radius_step(const ParentAndChild& family);              ///< patch-radius-step
std::optional<ClaimWitness> judge_child_bound(const ParentAndChild& family);              ///< child-distance-bound
std::optional<ClaimWitness> judge_child_bound_repaired(const ParentAndChild& family);     ///< ...-repaired

/// A number of Q(m^(1/3)) as a witness shows it: exactly, and between two decimals.
std::string shown(const CubeRootNumber& number);

}  // namespace asts
