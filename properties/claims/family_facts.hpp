#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "lib/mesh/setting.hpp"
#include "properties/claims/claim.hpp"
#include "properties/witness.hpp"

namespace asts {

/// What the equations of Appendix A speak about: an element K^ and one of its children K, in numbers.
struct ParentAndChild {
  Setting setting;
  ElementInfo parent;
  ElementInfo child;
  int number = 1;  ///< the child's j in Definition 2.5: 1, ..., m
};

/// Decides an equation for one pair; nothing when it holds.
using FamilyJudge = std::optional<ClaimWitness> (*)(const ParentAndChild&);

/// The pairs of a mesh's refinement tree.
std::vector<ParentAndChild> families_of(const MeshUnderTest& mesh);

/// All m children of one element of that level: the last child of the last child ... of the unit cube [0,1]^3, by
/// Definitions 2.5 and 2.6.
std::vector<ParentAndChild> families_at(const Setting& setting, int parent_level);

/// Every m from 2 to 20, parents of the levels 0 to 12, every child, with degrees that differ along the axes.
std::vector<ParentAndChild> families_of_every_grading();

/// The first violation, and the number of pairs up to it. Not applicable without pairs.
Trial judge_families(const std::vector<ParentAndChild>& families, FamilyJudge judge);

/// The degrees, as a witness shows them.
ExactPoint to_point(const PerAxis<int>& degree);

/// mid(K).
ExactPoint midpoint(const ExactBox& box);

/// Definition 2.3: Dist of two elements.
ExactPoint distance(const ExactBox& a, const ExactBox& b);

/// The sides of a box.
ExactPoint sides(const ExactBox& box);

}  // namespace asts
