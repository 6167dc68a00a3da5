#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/mesh/mesh.hpp"

namespace asts {

/// The vertices of a mesh's elements, hanging ones too, each once.
struct MeshPoints {
  static constexpr std::size_t kCorners = std::size_t{1} << kDimension;

  std::vector<PerAxis<std::int32_t>> positions;  ///< ranks, in lexicographic order
  std::vector<std::int32_t>
      corners;  ///< 8 an element: numbers of points; corner c lies up along axis a where bit a is set
};

/// Cost: linear in elements and lines. Throws ResourceError for more than 2^28 - 1 elements.
MeshPoints mesh_points(const Mesh& mesh);

}  // namespace asts
