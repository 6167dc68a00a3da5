#pragma once

#include <string>
#include <vector>

#include "properties/mesh_under_test.hpp"

namespace asts {

/// What is worth counting about a mesh that claims are tried on:
/// "supports-touch-in-face", "-edge", "-point": two active nodes have supports with just that in common;
/// "refined-outside-region": an element that is no unit cube reaches outside the active region;
/// "not-admissible": Definition 3.2.
std::vector<std::string> features_of(MeshUnderTest& mesh);

}  // namespace asts
