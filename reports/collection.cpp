#include "reports/collection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lib/mesh/case_file.hpp"
#include "lib/mesh/fnv1a.hpp"

namespace asts {

namespace {

constexpr std::string_view kSuffix = ".case";
constexpr std::size_t kHashDigits = 16;

bool is_hash(std::string_view word) {
  return word.size() == kHashDigits &&
         std::all_of(word.begin(), word.end(), [](char c) { return ('0' <= c && c <= '9') || ('a' <= c && c <= 'f'); });
}

/// The statement with the longest id that the stem is, or begins with before a '-'.
std::optional<Statement> statement_before(std::string_view stem) {
  for (std::size_t length = stem.size(); length > 0; length = stem.substr(0, length).rfind('-')) {
    if (auto statement = find_statement(stem.substr(0, length))) return statement;
    if (stem.substr(0, length).rfind('-') == std::string_view::npos) break;
  }
  return std::nullopt;
}

}  // namespace

std::string collection_hash(const Case& test_case) {
  return fmt::format("{:016x}", fnv1a(write_case(test_case)));
}

std::string collection_name(const std::string& statement, const std::string& kind, const Case& test_case) {
  return fmt::format("{}-{}-{}{}", statement, kind, collection_hash(test_case), kSuffix);
}

std::optional<CollectedName> parse_collection_name(std::string_view name) {
  if (!name.ends_with(kSuffix)) return std::nullopt;
  std::string_view stem = name.substr(0, name.size() - kSuffix.size());
  const auto statement = statement_before(stem);
  if (!statement) return std::nullopt;
  CollectedName result{*statement, {}, {}};
  stem.remove_prefix(std::string_view(statement->id()).size());
  const std::size_t last = stem.rfind('-');
  if (last == std::string_view::npos || !is_hash(stem.substr(last + 1))) return result;
  result.hash = std::string(stem.substr(last + 1));
  if (last > 0) result.kind = std::string(stem.substr(1, last - 1));
  return result;
}

bool expected_violated(const Statement& statement) { return statement.claim == nullptr || statement.claim->refuted; }

}  // namespace asts
