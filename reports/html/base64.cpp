#include "reports/html/base64.hpp"

#include <cstddef>

namespace asts {

namespace {

constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Collects bytes into groups of three, which four digits stand for.
class Encoder {
 public:
  explicit Encoder(std::size_t bytes) { text_.reserve((bytes + 2) / 3 * 4); }

  void add(std::uint32_t byte) {
    group_ = group_ << 8 | byte;
    if (++count_ == 3) write(4);
  }

  std::string finish() && {
    if (count_ != 0) {
      const std::size_t digits = count_ + 1;
      for (std::size_t missing = count_; missing < 3; ++missing) group_ <<= 8;
      write(digits);
      text_.append(4 - digits, '=');
    }
    return std::move(text_);
  }

 private:
  void write(std::size_t digits) {
    for (std::size_t i = 0; i < digits; ++i) text_ += kDigits[group_ >> (18 - 6 * i) & 63U];
    group_ = 0;
    count_ = 0;
  }

  std::string text_;
  std::uint32_t group_ = 0;
  std::size_t count_ = 0;
};

}  // namespace

std::string base64_of(const std::vector<std::int32_t>& numbers) {
  Encoder encoder(4 * numbers.size());
  for (const std::int32_t number : numbers) {
    const auto bits = static_cast<std::uint32_t>(number);
    for (unsigned shift = 0; shift < 32; shift += 8) encoder.add(bits >> shift & 255U);
  }
  return std::move(encoder).finish();
}

}  // namespace asts
