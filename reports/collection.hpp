#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "properties/statement.hpp"

namespace asts {

/// A collection is a folder of case files, each named after what it once violated: `<claim>-<kind>-<hash>.case`, with a
/// property's id in place of the claim's, or shorter: `<claim>.case`, `<claim>-<words>.case`. The hash is that of the
/// case's canonical text, so that comments may change and the case may not.
struct CollectedName {
  Statement statement;
  std::string kind;                 ///< empty in a short name
  std::optional<std::string> hash;  ///< 16 hexadecimal digits; none in a short name
};

/// "<claim>-<kind>-<hash>.case".
std::string collection_name(const std::string& statement, const std::string& kind, const Case& test_case);

/// What a file's name without its folder says; nothing when it begins with no id. Of several ids the longest counts.
std::optional<CollectedName> parse_collection_name(std::string_view name);

/// The hash of a case in a name: FNV-1a, 64 bits, of its canonical text.
std::string collection_hash(const Case& test_case);

/// What a replay of a collected case must give. A case of a refuted claim, or of a property, must be violated still. A
/// case of a claim that is not refuted stands for a fault of the program that was repaired: it must not be violated.
bool expected_violated(const Statement& statement);

}  // namespace asts
