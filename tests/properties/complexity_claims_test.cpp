#include <gtest/gtest.h>

#include "tests/properties/claim_checks.hpp"

namespace asts {

std::vector<NegativeControl> complexity_controls() { return {}; }

std::vector<Confirmation> complexity_confirmations() { return {}; }

}  // namespace asts
