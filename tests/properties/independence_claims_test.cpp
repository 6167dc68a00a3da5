#include <gtest/gtest.h>

#include "tests/properties/claim_checks.hpp"

namespace asts {

std::vector<NegativeControl> independence_controls() { return {}; }

std::vector<Confirmation> independence_confirmations() { return {}; }

}  // namespace asts
