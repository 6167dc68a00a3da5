#include "lib/mesh/case_text.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace asts {
namespace {

constexpr std::size_t kLongestShown = 40;
constexpr std::size_t kShortened = 24;

bool is_continuation(std::string_view text, std::size_t at) {
  return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
}

/// The length of the UTF-8 sequence that begins at `at`, 0 when it is none (RFC 3629: no overlong forms, no
/// surrogates, nothing above U+10FFFF).
std::size_t sequence_length(std::string_view text, std::size_t at) {
  const unsigned lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x80) return 1;
  if (lead < 0xC2 || lead > 0xF4 || !is_continuation(text, at + 1)) return 0;
  if (lead < 0xE0) return 2;
  const unsigned second = static_cast<unsigned char>(text[at + 1]);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool outside = (lead == 0xED && second > 0x9F) || (lead == 0xF4 && second > 0x8F);
  if (overlong || outside || !is_continuation(text, at + 2)) return 0;
  if (lead < 0xF0) return 3;
  return is_continuation(text, at + 3) ? 4 : 0;
}

/// Where the first byte stands that is not part of valid UTF-8; text.size() when all are.
std::size_t first_invalid_utf8(std::string_view text) {
  constexpr std::uint64_t kHighBits = 0x8080808080808080U;
  std::size_t at = 0;
  while (at < text.size()) {
    std::uint64_t eight = kHighBits;
    if (text.size() - at >= sizeof eight) std::memcpy(&eight, text.data() + at, sizeof eight);
    if ((eight & kHighBits) == 0) {  // eight ASCII characters at once
      at += sizeof eight;
      continue;
    }
    const std::size_t length = sequence_length(text, at);
    if (length == 0) return at;
    at += length;
  }
  return at;
}

std::string_view without_comment(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line.substr(0, line.find('#'));
}

}  // namespace

void fail_at(const std::string& name, std::size_t line, const std::string& reason) {
  throw CaseFileError(name + ":" + std::to_string(line) + ": " + reason);
}

std::string shown(std::string_view word) {
  static constexpr std::string_view kHex = "0123456789ABCDEF";
  const bool is_long = word.size() > kLongestShown;
  std::string result;
  for (const char c : word.substr(0, is_long ? kShortened : word.size())) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F) {
      result += c;
    } else {
      result += {'\\', 'x', kHex[byte >> 4U], kHex[byte & 15U]};
    }
  }
  if (is_long) result += "... (" + std::to_string(word.size()) + " characters)";
  return result;
}

std::string quote(std::string_view word) { return "'" + shown(word) + "'"; }

std::size_t split(std::string_view rest, std::span<std::string_view> words) {
  std::size_t count = 0;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
    if (count < words.size()) words[count] = word;
    ++count;
  }
  return count;
}

CaseLines::CaseLines(std::string_view text, const std::string& name) : name_(name), text_(text) {
  bad_ = std::min({first_invalid_utf8(text), text.find('\0'), text.size()});
  if (text.starts_with("\xEF\xBB\xBF")) next_ = 3;
}

void CaseLines::take_line() {
  const std::size_t end = std::min(text_.find('\n', next_), text_.size());
  ++number_;
  if (bad_ < end) fail(text_[bad_] == '\0' ? "a NUL byte: this is not a text file" : "invalid UTF-8");
  line_ = without_comment(text_.substr(next_, end - next_));
  next_ = end + 1;
}

bool CaseLines::next() {
  while (next_ < text_.size()) {
    take_line();
    std::string_view rest = line_;
    if (!next_word(rest).empty()) return true;
  }
  return false;
}

}  // namespace asts
