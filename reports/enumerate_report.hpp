#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace asts {

/// What `asts enumerate` found out about one claim or property. Counts are numbers of distinct meshes.
struct EnumerationRecord {
  std::string kind;  ///< "claim" or "property"
  std::string id;
  std::int64_t meshes = 0;
  std::int64_t violations = 0;
  std::int64_t not_applicable = 0;
  std::int64_t undecided = 0;
  /// The sum of Trial::met. A property has no such number.
  std::optional<std::int64_t> met;
  /// A violating mesh with the fewest subdivisions, as a case: the first of them in the canonical order.
  std::optional<std::string> smallest;
  std::int64_t fewest = 0;  ///< its subdivisions

  std::int64_t applicable() const { return meshes - not_applicable - undecided; }
};

/// The record as one line of JSON, with a line end.
std::string enumeration_json(const EnumerationRecord& record);

/// For a person: a header, one line a record, and the smallest violating mesh of a record, if there is one.
std::string enumeration_text_header();
std::string enumeration_text(const EnumerationRecord& record);
std::string smallest_text(const EnumerationRecord& record);

}  // namespace asts
