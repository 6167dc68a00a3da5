#include <gtest/gtest.h>

#include "tests/properties/claim_checks.hpp"

namespace asts {

std::vector<NegativeControl> functional_controls() { return {}; }

std::vector<Confirmation> functional_confirmations() { return {}; }

}  // namespace asts
