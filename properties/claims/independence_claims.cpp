#include "properties/claims/claim.hpp"

namespace asts {

std::span<const Claim> independence_claims() { return {}; }

}  // namespace asts
