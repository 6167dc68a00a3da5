#pragma once

#include <string>
#include <vector>

#include "properties/claims/claim.hpp"
#include "properties/properties.hpp"

namespace asts::cli {

/// What --property and --claim name, each once: properties in the order of the table, claims in the order given. Throws
/// InputError for an id that nothing has.
std::vector<const Property*> chosen_properties(const std::vector<std::string>& ids);
std::vector<const Claim*> chosen_claims(const std::vector<std::string>& ids);

}  // namespace asts::cli
