#include "lib/mesh/case_numbers.hpp"

#include <utility>
#include <variant>

namespace asts {
namespace {

__extension__ using WideInteger = __int128;

bool is_number(std::string_view word) { return std::holds_alternative<CompactRational>(parse_compact(word)); }

/// Why the word is no number. parse_compact gives a reason too, but shows the word as it is: control characters in
/// a file must not reach a terminal.
std::string reason(std::string_view word) {
  const std::size_t slash = word.find('/');
  const bool is_fraction = slash != word.npos && is_number(word.substr(0, slash)) && slash + 1 < word.size();
  if (is_fraction && word.find_first_not_of('0', slash + 1) == word.npos) return " has the denominator zero";
  return " is not a number: expected an integer or a/b";
}

}  // namespace

bool less(const CompactRational& a, const CompactRational& b) {
  if (!a.is_small() || !b.is_small()) return a.value() < b.value();
  // Products of 64-bit numbers fit into 128 bits.
  return WideInteger{a.numerator()} * b.denominator() < WideInteger{b.numerator()} * a.denominator();
}

CompactRational number_in(const CaseLines& lines, std::string_view word) {
  auto parsed = parse_compact(word);
  if (auto* value = std::get_if<CompactRational>(&parsed)) return std::move(*value);
  lines.fail(quote(word) + reason(word));
}

int integer_in(const CaseLines& lines, const std::string& what, std::string_view word, std::int64_t low,
               std::int64_t high) {
  const CompactRational value = number_in(lines, word);
  const auto refuse = [&](const std::string& why) { lines.fail("the " + what + " " + quote(word) + why); };
  if (less(value, CompactRational(low))) refuse(" is below " + std::to_string(low));
  if (less(CompactRational(high), value)) refuse(" is above " + std::to_string(high));
  if (!value.is_small() || value.denominator() != 1) refuse(" is not an integer");
  return static_cast<int>(value.numerator());
}

void require_count(const CaseLines& lines, std::size_t count, std::size_t expected, const char* needs) {
  if (count != expected) lines.fail(needs + (", found " + std::to_string(count)));
}

}  // namespace asts
