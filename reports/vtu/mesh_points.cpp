#include "reports/vtu/mesh_points.hpp"

#include <limits>
#include <numeric>

#include "lib/exact/errors.hpp"
#include "lib/spline/active_nodes.hpp"

namespace asts {

namespace {

std::vector<PerAxis<std::int32_t>> all_corners(const Mesh& mesh) {
  std::vector<PerAxis<std::int32_t>> corners;
  corners.reserve(MeshPoints::kCorners * mesh.elements.size());
  for (const Box& box : mesh.elements) {
    for (std::size_t corner = 0; corner < MeshPoints::kCorners; ++corner) {
      PerAxis<std::int32_t>& position = corners.emplace_back();
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        position[axis] = (corner >> axis & 1) != 0 ? box.upper[axis] : box.lower[axis];
      }
    }
  }
  return corners;
}

}  // namespace

MeshPoints mesh_points(const Mesh& mesh) {
  if (mesh.elements.size() > at(std::numeric_limits<std::int32_t>::max()) / MeshPoints::kCorners) {
    throw ResourceError("too many elements for one grid of VTK");
  }
  const auto corners = all_corners(mesh);
  std::vector<std::int32_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  for (Axis axis = kDimension - 1; axis >= 0; --axis) stable_sort_by_axis(mesh, corners, axis, order);
  MeshPoints points;
  points.corners.resize(corners.size());
  for (const std::int32_t corner : order) {
    if (points.positions.empty() || points.positions.back() != corners[at(corner)]) {
      points.positions.push_back(corners[at(corner)]);
    }
    points.corners[at(corner)] = static_cast<std::int32_t>(points.positions.size()) - 1;
  }
  return points;
}

}  // namespace asts
