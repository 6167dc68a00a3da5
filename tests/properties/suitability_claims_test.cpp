#include <gtest/gtest.h>

#include "tests/properties/claim_checks.hpp"

namespace asts {

std::vector<NegativeControl> suitability_controls() { return {}; }

std::vector<Confirmation> suitability_confirmations() { return {}; }

}  // namespace asts
