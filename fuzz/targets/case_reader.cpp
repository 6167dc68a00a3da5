#include <algorithm>
#include <cstdlib>

#include "fuzz/targets/small_case.hpp"
#include "fuzz/targets/targets.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/refine/replay.hpp"

namespace asts::fuzz {

namespace {

constexpr std::string_view kName = "bytes";
constexpr std::int64_t kMostElements = 200;

/// "bytes:LINE: reason" with a line of the text, counted from 1; one behind the last counts as its end.
bool names_a_line(std::string_view message, std::string_view text) {
  if (!message.starts_with(kName) || message.substr(kName.size(), 1) != ":") return false;
  message.remove_prefix(kName.size() + 1);
  const std::size_t digits = message.find_first_not_of("0123456789");
  if (digits == 0 || digits > 9 || message.substr(digits, 2) != ": ") return false;
  const long line = std::strtol(std::string(message.substr(0, digits)).c_str(), nullptr, 10);
  return line >= 1 && line <= 1 + std::count(text.begin(), text.end(), '\n');
}

Fault round_trip_fault(const Case& content) {
  const std::string text = write_case(content);
  const Case again = parse_case(text, std::string(kName));
  if (again != content) return "written and read again it is another case:\n" + text;
  if (write_case(again) != text) return "written, read and written again it has another text:\n" + text;
  return std::nullopt;
}

/// Boxes that do not tile the domain are the text's fault, and the message begins with the line of one of them.
Fault mesh_fault(const Case& content) {
  if (!content.explicit_mesh) {
    Replay replay(content);
    while (!replay.done()) replay.advance();
    return std::nullopt;
  }
  try {
    mesh_of(setting_of(content), content.elements);
  } catch (const InputError& error) {
    const std::size_t line = static_cast<std::size_t>(std::strtoul(error.what(), nullptr, 10));
    const auto stands_there = [&](const ElementLine& element) { return element.line == line; };
    if (std::none_of(content.elements.begin(), content.elements.end(), stands_there)) return error.what();
  }
  return std::nullopt;
}

}  // namespace

Fault case_reader_fault(Bytes bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  Case content;
  try {
    content = parse_case(text, std::string(kName));
  } catch (const CaseFileError& error) {
    if (names_a_line(error.what(), text)) return std::nullopt;
    return std::string("the message names no line of the text: ") + error.what();
  }
  if (Fault fault = round_trip_fault(content)) return fault;
  return is_small(content, kMostElements) ? mesh_fault(content) : std::nullopt;
}

}  // namespace asts::fuzz
