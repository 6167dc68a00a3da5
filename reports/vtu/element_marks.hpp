#pragma once

#include <cstdint>
#include <vector>

#include "properties/mesh_under_test.hpp"
#include "properties/witness.hpp"

namespace asts {

/// Marks of elements, a number for each in the mesh's order; 0: none.

/// 1 for elements that share volume with the support of an active node's blending function.
/// REQUIRES: all index vectors exist.
std::vector<std::uint8_t> marks_of_support(MeshUnderTest& mesh, std::int32_t node);

/// The number, from 1, of the first box that the element shares volume with. Boxes outside the domain mark nothing.
std::vector<std::int32_t> marks_of_boxes(const Mesh& mesh, const std::vector<ExactBox>& boxes);

/// 1 for closed elements that meet the perturbed region of an axis (Definition 5.1).
/// REQUIRES: all index vectors exist. Cost: that of the regions and linear in what meets each of their boxes.
std::vector<std::uint8_t> marks_of_perturbed_region(MeshUnderTest& mesh, Axis axis);

}  // namespace asts
