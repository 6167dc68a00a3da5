#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tests/reference/mesh.hpp"

namespace asts::reference {

struct Validation {
  bool valid = false;
  std::string report;  ///< plain words: the hypotheses that hold and the conclusion that fails, or the reason against it
};

/// Decides a witness of reports/WITNESS.md for the mesh from the definitions: every key, every number, and whether they
/// really refute the property. Anything malformed gives an invalid result with the reason; nothing is thrown.
Validation validate_witness(const Setting& setting, const Mesh& mesh, const std::string& property,
                            const nlohmann::json& witness);

}  // namespace asts::reference
