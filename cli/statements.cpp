#include "cli/statements.hpp"

#include <algorithm>

#include "lib/exact/errors.hpp"

namespace asts::cli {

std::vector<const Property*> chosen_properties(const std::vector<std::string>& ids) {
  for (const std::string& id : ids) {
    if (find_property(id) == nullptr) throw InputError("no property is called '" + id + "'");
  }
  std::vector<const Property*> chosen;
  for (const Property& property : all_properties()) {
    if (std::find(ids.begin(), ids.end(), property.id) != ids.end()) chosen.push_back(&property);
  }
  return chosen;
}

std::vector<const Claim*> chosen_claims(const std::vector<std::string>& ids) {
  std::vector<const Claim*> chosen;
  for (const std::string& id : ids) {
    const Claim* claim = find_claim(id);
    if (claim == nullptr) throw InputError("no claim is called '" + id + "'");
    if (std::find(chosen.begin(), chosen.end(), claim) == chosen.end()) chosen.push_back(claim);
  }
  return chosen;
}

MeshStatement statement_of(const Property& property) {
  const bool of_splines = property.decide == decide_analysis_suitable || property.decide == decide_dual_compatible ||
                          property.decide == decide_dual_basis;
  const auto decide_it = [&property](MeshUnderTest& mesh) { return Trial{decide(property, mesh)}; };
  return {"property", property.id, decide_it, true, of_splines};
}

MeshStatement statement_of(const Claim& claim) {
  if (claim.on_mesh == nullptr) throw InputError("claim '" + std::string(claim.id) + "' is not about one mesh");
  const auto decide_it = [&claim](MeshUnderTest& mesh) { return try_on_mesh(claim, mesh); };
  return {"claim", claim.id, decide_it, claim.reflects, claim.of_splines};
}

}  // namespace asts::cli
