#pragma once

#include <cstdint>

#include "lib/mesh/case.hpp"

namespace asts::fuzz {

/// Whether no mesh of the case can have more elements than this, judged without making one: each step replaces an
/// element by m of them at most.
bool is_small(const Case& content, std::int64_t most_elements);

}  // namespace asts::fuzz
