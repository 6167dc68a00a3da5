#include "tests/reference/claim_witness.hpp"

namespace asts::reference {

std::span<const ClaimKind> independence_kinds() { return {}; }

}  // namespace asts::reference
