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

}  // namespace asts::cli
