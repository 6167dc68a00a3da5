#include "tests/reference/claim_witness.hpp"

namespace asts::reference {

std::span<const ClaimKind> theorem_5_3_kinds() { return {}; }

}  // namespace asts::reference
