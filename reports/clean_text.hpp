#pragma once

#include <string>
#include <string_view>

namespace asts {

/// The text with U+FFFD for each byte that belongs to no well-formed UTF-8 sequence and for each character that XML 1.0
/// does not have: control characters but tab, line feed and carriage return, surrogates, U+FFFE and U+FFFF. What is
/// clean stays as it is.
std::string clean_text(std::string_view text);

}  // namespace asts
