#include "properties/claims/claim.hpp"

namespace asts {

std::span<const Claim> suitability_claims() { return {}; }

}  // namespace asts
