#include <gtest/gtest.h>

#include "tests/properties/claim_checks.hpp"

namespace asts {

std::vector<NegativeControl> refinement_controls() { return {}; }

std::vector<Confirmation> refinement_confirmations() { return {}; }

}  // namespace asts
