#include "reports/base64.hpp"

namespace asts {

std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t digit = 0; digit < 4; ++digit) {
      text += i + digit > bytes.size() ? '=' : kDigits[word >> (18 - 6 * digit) & 63];
    }
  }
  return text;
}

std::string base64_of(const std::vector<std::int32_t>& numbers) {
  std::string bytes;
  bytes.reserve(4 * numbers.size());
  for (const std::int32_t number : numbers) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
      bytes += static_cast<char>(static_cast<std::uint32_t>(number) >> shift & 255U);
    }
  }
  return base64(bytes);
}

}  // namespace asts
