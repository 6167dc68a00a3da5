#include "properties/properties.hpp"

#include <array>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

constexpr std::array kProperties{
    Property{"admissible", "Definition 3.2",
             "a sequence of admissible subdivisions makes the mesh from the initial one", decide_admissible,
             admissible_in_sequence},
    Property{"nested-patches", "Lemma 3.4",
             "K within L implies that the patch of K lies in the patch of L, for all elements of the refinement tree",
             decide_nested_patches, nested_patches_in_sequence},
    Property{"analysis-suitable", "Definition 5.2", "no two of the perturbed regions R_x, R_y, R_z meet",
             decide_analysis_suitable, analysis_suitable_in_sequence},
    Property{"dual-compatible", "Definition 6.4",
             "any two active nodes whose supports share volume have index vectors that overlap along two axes at least",
             decide_dual_compatible, dual_compatible_in_sequence},
    Property{"dual-basis", "Definition 6.2", "lambda_v(B_w) = delta_vw for all active nodes v, w", decide_dual_basis,
             dual_basis_in_sequence},
};

}  // namespace

const char* outcome_name(Outcome outcome) {
  switch (outcome) {
    case Outcome::holds:
      return "holds";
    case Outcome::violated:
      return "violated";
    case Outcome::not_applicable:
      return "not-applicable";
    case Outcome::undecided:
      return "undecided";
  }
  throw InternalError("an outcome without a name");
}

std::span<const Property> all_properties() { return kProperties; }

const Property* find_property(std::string_view id) {
  for (const Property& property : kProperties) {
    if (property.id == id) return &property;
  }
  return nullptr;
}

Verdict decide(const Property& property, MeshUnderTest& mesh) {
  try {
    return property.decide(mesh);
  } catch (const BudgetExhausted& exhausted) {
    return Verdict::undecided(exhausted.what());
  }
}

}  // namespace asts
