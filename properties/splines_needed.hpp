#pragma once

#include <optional>

#include "properties/mesh_under_test.hpp"
#include "properties/verdict.hpp"

namespace asts {

/// The verdict `not_applicable` when the mesh has no active node, or an active node lacks an index vector so that its
/// blending function is not defined; nothing when splines can be spoken of.
std::optional<Verdict> lacks_splines(MeshUnderTest& mesh);

}  // namespace asts
