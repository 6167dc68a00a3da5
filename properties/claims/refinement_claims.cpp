#include "properties/claims/claim.hpp"

namespace asts {

std::span<const Claim> refinement_claims() { return {}; }

}  // namespace asts
