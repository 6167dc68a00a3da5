#include "properties/claims/claim.hpp"

namespace asts {

std::span<const Claim> functional_claims() { return {}; }

}  // namespace asts
