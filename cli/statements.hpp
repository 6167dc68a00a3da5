#pragma once

#include <functional>
#include <string>
#include <vector>

#include "properties/claims/claim.hpp"
#include "properties/properties.hpp"

namespace asts::cli {

/// What --property and --claim name, each once: properties in the order of the table, claims in the order given. Throws
/// InputError for an id that nothing has.
std::vector<const Property*> chosen_properties(const std::vector<std::string>& ids);
std::vector<const Claim*> chosen_claims(const std::vector<std::string>& ids);

/// A property or a claim about one mesh.
struct MeshStatement {
  const char* kind;  ///< "property" or "claim"
  const char* id;
  std::function<Trial(MeshUnderTest&)> decide;  ///< a property meets nothing
  bool reflects;                                ///< see Claim
  bool of_splines;                              ///< see Claim
};

MeshStatement statement_of(const Property& property);
/// Throws InputError for a claim that is not about one mesh.
MeshStatement statement_of(const Claim& claim);

}  // namespace asts::cli
