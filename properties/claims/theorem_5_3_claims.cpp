#include "properties/claims/claim.hpp"

namespace asts {

std::span<const Claim> theorem_5_3_claims() { return {}; }

}  // namespace asts
