#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/reference/validate.hpp"

namespace asts {

/// What the literal code says of one witness of a record.
struct ValidatedWitness {
  const char* statement;  ///< "property" or "claim"
  std::string id;
  reference::Validation validation;
};

/// A line of `asts check --format json` or of a campaign's findings; nothing when it is no such record.
std::optional<nlohmann::json> parse_record(const std::string& line);

/// Decides every witness of a record with the literal code of tests/reference, which shares nothing with the kernel but
/// the rational number. The record carries its case as `mesh`, or names it as `case`: a path, tried as it is and beside
/// `file`. `place` (FILE:LINE) begins every message.
/// Throws InputError when the record or its case is malformed. Cost: that of the literal code, quadratic in the mesh.
std::vector<ValidatedWitness> validate_record(const nlohmann::json& record, const std::string& file,
                                              const std::string& place);

}  // namespace asts
