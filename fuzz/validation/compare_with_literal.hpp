#pragma once

#include <optional>
#include <string>

#include "properties/mesh_under_test.hpp"
#include "tests/reference/decide.hpp"

namespace asts {

/// How the mesh kernel and the literal code differ about a mesh.
struct LiteralDifference {
  std::string about;  ///< "the elements", "PROPERTY" or "the witness against PROPERTY"
  std::string says;   ///< in words
};

/// Compares the elements, the verdicts on the five properties, and has every witness decided by the literal code.
/// `boxes` is the mesh as the literal code made it, in any order.
/// Nothing when all agree. Cost: that of the literal code, quadratic in the mesh.
std::optional<LiteralDifference> compare_with_literal(MeshUnderTest& mesh, const reference::Setting& setting,
                                                      const reference::Mesh& boxes);

}  // namespace asts
