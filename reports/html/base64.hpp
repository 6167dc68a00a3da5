#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace asts {

/// Base64 (RFC 4648, section 4, with padding) of the numbers as 32-bit integers, the least significant byte first,
/// whatever the machine's own order. Cost: linear.
std::string base64_of(const std::vector<std::int32_t>& numbers);

}  // namespace asts
