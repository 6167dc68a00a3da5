#include "reports/clean_text.hpp"

#include <cstdint>

namespace asts {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// A character that a text begins with: how many bytes it has; 0 when no well-formed sequence begins there.
struct Character {
  std::size_t bytes = 0;
  std::uint32_t code = 0;
};

/// The bytes of a sequence by its first one, and the least code that needs so many.
Character first_byte(unsigned char byte) {
  if (byte < 0x80) return {1, byte};
  if (byte >= 0xC0 && byte < 0xE0) return {2, byte & 0x1FU};
  if (byte >= 0xE0 && byte < 0xF0) return {3, byte & 0x0FU};
  if (byte >= 0xF0 && byte < 0xF8) return {4, byte & 0x07U};
  return {};
}

Character character_at(std::string_view text) {
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  Character result = first_byte(static_cast<unsigned char>(text.front()));
  if (result.bytes == 0 || result.bytes > text.size()) return {};
  for (std::size_t i = 1; i < result.bytes; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0U) != 0x80U) return {};
    result.code = (result.code << 6) | (byte & 0x3FU);
  }
  return result.code < kLeast[result.bytes] ? Character{} : result;
}

bool is_xml_character(std::uint32_t code) {
  if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
  if (code >= 0xD800 && code < 0xE000) return false;
  return code != 0xFFFE && code != 0xFFFF && code <= 0x10FFFF;
}

}  // namespace

std::string clean_text(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Character next = character_at(text);
    const std::size_t bytes = next.bytes == 0 ? 1 : next.bytes;
    result += next.bytes > 0 && is_xml_character(next.code) ? text.substr(0, bytes) : kReplacement;
    text.remove_prefix(bytes);
  }
  return result;
}

}  // namespace asts
