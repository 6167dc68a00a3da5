#include <gtest/gtest.h>

#include "tests/properties/claim_checks.hpp"

namespace asts {

std::vector<NegativeControl> equation_controls() { return {}; }

std::vector<Confirmation> equation_confirmations() { return {}; }

}  // namespace asts
