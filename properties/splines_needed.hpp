#pragma once

#include <optional>

#include "properties/mesh_under_test.hpp"
#include "properties/verdict.hpp"

namespace asts {

/// The verdict `not_applicable` when the mesh has no active node, or an active node lacks an index vector so that its
/// blending function is not defined; nothing when splines can be spoken of.
std::optional<Verdict> lacks_splines(MeshUnderTest& mesh);

/// The verdict `not_applicable` on a mesh without active nodes.
Verdict without_active_nodes(bool region_is_empty);

}  // namespace asts
