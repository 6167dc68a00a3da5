#pragma once

#include <string>
#include <string_view>

namespace asts {

/// RFC 4648, section 4, with padding. Cost: linear.
std::string base64(std::string_view bytes);

}  // namespace asts
