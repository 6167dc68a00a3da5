#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reports/slices/slice_marks.hpp"
#include "reports/vtu/blending_values.hpp"
#include "reports/vtu/mesh_points.hpp"
#include "reports/vtu/mesh_vtu.hpp"

namespace asts {

/// What a grid's arrays are made from, beside its points and cells.
struct DrawnMesh {
  MeshUnderTest& test;
  const VtuChoice& choice;
  SliceMarks witness;                        ///< empty without one
  std::optional<BlendingFunction> function;  ///< of the chosen node
  BlendingSamples samples;
  MeshPoints vertices;                    ///< the grid's first points
  std::vector<std::int32_t> node_points;  ///< the point of each active node
  std::vector<std::uint8_t> kinds;        ///< of each cell
  std::size_t points = 0;                 ///< of the grid
};

/// The arrays that mesh_vtu describes. Those of cells count what they mark.
std::vector<VtuArray> cell_arrays(const DrawnMesh& drawn_mesh, VtuCounts& counts);
std::vector<VtuArray> point_arrays(const DrawnMesh& drawn_mesh);
std::vector<VtuArray> field_arrays(const DrawnMesh& drawn_mesh);

/// "perturbed_x"
std::string array_name(const char* name, Axis axis);

}  // namespace asts
