#include "lib/spline/hanging.hpp"

#include <algorithm>
#include <tuple>

namespace asts {

namespace {

auto key(const Box& box) { return std::tie(box.lower, box.upper); }

void keep_each_once(std::vector<Box>& boxes) {
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return key(a) < key(b); });
  boxes.erase(std::unique(boxes.begin(), boxes.end()), boxes.end());
}

/// The vertices (no axis) or the edges along an axis of all elements, each once.
std::vector<Box> vertices_or_edges(const Mesh& mesh, Axis along) {
  std::vector<Box> result;
  for (const Box& element : mesh.elements) {
    for (std::size_t corner = 0; corner < (std::size_t{1} << kDimension); ++corner) {
      Box box = element;
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const bool upper = (corner >> axis & 1) != 0;
        if (axis == along) continue;
        (upper ? box.lower : box.upper)[at(axis)] = (upper ? element.upper : element.lower)[at(axis)];
      }
      result.push_back(box);
    }
  }
  keep_each_once(result);
  return result;
}

bool strictly_inside(const Box& element, Axis axis, std::int32_t rank) {
  return element.lower[at(axis)] < rank && rank < element.upper[at(axis)];
}

/// A point inside the box's piece that begins `offset` lines after its lower end along an axis; the point itself when
/// the box has no extent.
PerAxis<HalfRank> point_of_piece(const Box& box, Axis along, std::int32_t offset) {
  PerAxis<HalfRank> point;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    point[at(axis)] = 2 * box.lower[at(axis)] + (axis == along ? 2 * offset + 1 : 0);
  }
  return point;
}

void add_hanging(const Mesh& mesh, const Box& box, const PerAxis<HalfRank>& point, std::vector<Hanging>& result) {
  for (const std::int32_t element : elements_at(mesh, point)) {
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const bool point_like = box.lower[at(axis)] == box.upper[at(axis)];
      if (!point_like || !strictly_inside(mesh.elements[at(element)], axis, box.lower[at(axis)])) continue;
      const Hanging found{box, element, axis};
      if (std::find(result.rbegin(), result.rend(), found) == result.rend()) result.push_back(found);
    }
  }
}

}  // namespace

std::vector<std::int32_t> elements_at(const Mesh& mesh, const PerAxis<HalfRank>& point) {
  std::vector<std::int32_t> result;
  for (std::size_t side = 0; side < (std::size_t{1} << kDimension); ++side) {
    PerAxis<std::int32_t> cell;
    bool inside = true;
    for (std::size_t axis = 0; axis < kDimension && inside; ++axis) {
      const bool below = (side >> axis & 1) != 0;
      cell[axis] = point[axis] / 2 - (below ? 1 : 0);
      const auto cells = static_cast<std::int32_t>(mesh.coordinates[axis].size()) - 1;
      inside = (!below || point[axis] % 2 == 0) && cell[axis] >= 0 && cell[axis] < cells;
    }
    if (!inside) continue;
    const std::int32_t element = mesh.locator.element_at(cell);
    if (std::find(result.begin(), result.end(), element) == result.end()) result.push_back(element);
  }
  return result;
}

bool in_skeleton(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& point) {
  const HalfRank position = point[at(axis)];
  for (const std::int32_t id : elements_at(mesh, point)) {
    const Box& element = mesh.elements[at(id)];
    if (2 * element.lower[at(axis)] == position || 2 * element.upper[at(axis)] == position) return true;
  }
  return false;
}

std::vector<Hanging> hanging_nodes(const Mesh& mesh) {
  constexpr Axis kNoAxis = -1;
  std::vector<Hanging> result;
  for (const Box& node : vertices_or_edges(mesh, kNoAxis)) {
    std::vector<Hanging> here;
    add_hanging(mesh, node, point_of_piece(node, kNoAxis, 0), here);
    result.insert(result.end(), here.begin(), here.end());
  }
  return result;
}

std::vector<Hanging> hanging_edges(const Mesh& mesh) {
  std::vector<Hanging> result;
  for (Axis along = 0; along < kDimension; ++along) {
    for (const Box& edge : vertices_or_edges(mesh, along)) {
      std::vector<Hanging> here;
      const std::int32_t pieces = edge.upper[at(along)] - edge.lower[at(along)];
      for (std::int32_t piece = 0; piece < pieces; ++piece) {
        add_hanging(mesh, edge, point_of_piece(edge, along, piece), here);
      }
      result.insert(result.end(), here.begin(), here.end());
    }
  }
  return result;
}

}  // namespace asts
