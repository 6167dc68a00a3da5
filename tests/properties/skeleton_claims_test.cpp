#include <gtest/gtest.h>

#include "tests/properties/claim_checks.hpp"

namespace asts {

std::vector<NegativeControl> skeleton_controls() { return {}; }

std::vector<Confirmation> skeleton_confirmations() { return {}; }

}  // namespace asts
