#include "properties/claims/claim.hpp"

namespace asts {

std::span<const Claim> skeleton_claims() { return {}; }

}  // namespace asts
