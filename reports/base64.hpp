#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace asts {

/// RFC 4648, section 4, with padding. Cost: linear.
std::string base64(std::string_view bytes);

/// Of the numbers as 32-bit integers, the least significant byte first, whatever the machine's own order. Cost: linear.
std::string base64_of(const std::vector<std::int32_t>& numbers);

}  // namespace asts
