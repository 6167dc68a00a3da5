#include <gtest/gtest.h>

#include "tests/properties/claim_checks.hpp"

namespace asts {

std::vector<NegativeControl> theorem_5_3_controls() { return {}; }

std::vector<Confirmation> theorem_5_3_confirmations() { return {}; }

}  // namespace asts
