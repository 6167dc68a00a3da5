#pragma once

#include <vector>

#include "lib/mesh/mesh.hpp"

namespace asts {

/// Proves that a mesh's boxes tile the domain, and builds the locator on the way: cuts the domain along sides of boxes
/// until each region is covered by one box. A box that a cut crosses is listed on either side.
/// Throws InputError "LINE: reason" for a gap or an overlap; `lines` are the boxes' lines, in the mesh's order.
/// Cost: O(n log n) for n boxes of a mesh that hierarchical cuts can make.
void build_tiling(Mesh& mesh, const std::vector<ElementLine>& lines);

}  // namespace asts
