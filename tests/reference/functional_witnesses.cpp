#include "tests/reference/claim_witness.hpp"

namespace asts::reference {

std::span<const ClaimKind> functional_kinds() { return {}; }

}  // namespace asts::reference
