#pragma once

#include <optional>

#include "properties/mesh_under_test.hpp"
#include "properties/verdict.hpp"

namespace asts {

/// `not-applicable` for a mesh with an element that level-directed subdivisions of the initial mesh cannot make.
inline std::optional<Verdict> outside_class(const MeshUnderTest& mesh) {
  if (!mesh.outside_class()) return std::nullopt;
  return Verdict::not_applicable("the mesh is no refinement of the initial mesh (Definition 2.6)");
}

/// `not-applicable` for a mesh that is not admissible (Definition 3.2).
inline std::optional<Verdict> not_admissible(MeshUnderTest& mesh) {
  if (mesh.admissible()) return std::nullopt;
  return Verdict::not_applicable("the mesh is not admissible");
}

}  // namespace asts
