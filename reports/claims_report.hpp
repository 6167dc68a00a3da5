#pragma once

#include <string>

#include "properties/claims/claim.hpp"

namespace asts {

/// "refuted" or "unrefuted".
const char* status_name(const Claim& claim);

/// What `asts claims` says about one claim: one line of JSON, or some lines for a person; with line ends.
std::string claim_json(const Claim& claim);
std::string claim_text(const Claim& claim);

}  // namespace asts
