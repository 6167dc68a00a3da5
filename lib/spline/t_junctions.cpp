#include "lib/spline/t_junctions.hpp"

#include <algorithm>

namespace asts {

PlanarEdges::PlanarEdges(std::array<std::int32_t, 2> lines, const std::vector<PlanarBox>& boxes) : lines_(lines) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    edges_[axis].assign(at(lines[0]) * at(lines[1]), false);
    for (const PlanarBox& box : boxes) {
      for (const std::int32_t side : {box.lower[1 - axis], box.upper[1 - axis]}) {
        std::array<std::int32_t, 2> crossing;
        crossing[1 - axis] = side;
        for (crossing[axis] = box.lower[axis]; crossing[axis] < box.upper[axis]; ++crossing[axis]) {
          edges_[axis][place(crossing)] = true;
        }
      }
    }
  }
}

bool PlanarEdges::edge(const std::array<std::int32_t, 2>& crossing, std::size_t axis, int direction) const {
  if (direction > 0) return edges_[axis][place(crossing)];
  if (crossing[axis] == 0) return false;
  std::array<std::int32_t, 2> before = crossing;
  --before[axis];
  return edges_[axis][place(before)];
}

namespace {

/// The T-junction at an inner crossing, if there is one.
std::optional<TJunction> junction_at(const PlanarEdges& edges, const std::array<std::int32_t, 2>& crossing) {
  std::optional<TJunction> missing;
  int count = 0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (const int direction : {+1, -1}) {
      if (edges.edge(crossing, axis, direction)) continue;
      missing = TJunction{crossing, axis, direction};
      ++count;
    }
  }
  return count == 1 ? missing : std::nullopt;
}

/// The n-th crossing with an edge across the axis from a crossing on, or the domain's border if there are fewer.
std::int32_t nth_entry(const PlanarEdges& edges, std::array<std::int32_t, 2> crossing, std::size_t axis, int direction,
                       int n) {
  while (n > 0) {
    const std::int32_t next = crossing[axis] + direction;
    if (next < 0 || next >= edges.lines(axis)) break;
    crossing[axis] = next;
    if (edges.crosses(crossing, axis)) --n;
  }
  return crossing[axis];
}

bool meet(const Extension& one, const Extension& other) {
  return one.lower <= other.line() && other.line() <= one.upper && other.lower <= one.line() &&
         one.line() <= other.upper;
}

bool by_box(const PlanarBox& a, const PlanarBox& b) { return a < b; }

}  // namespace

std::vector<TJunction> t_junctions(const PlanarEdges& edges) {
  std::vector<TJunction> result;
  for (std::int32_t i = 1; i + 1 < edges.lines(0); ++i) {
    for (std::int32_t j = 1; j + 1 < edges.lines(1); ++j) {
      if (const auto junction = junction_at(edges, {i, j})) result.push_back(*junction);
    }
  }
  return result;
}

Extension extension(const PlanarEdges& edges, const TJunction& junction, int degree) {
  const auto entry = [&](int direction, int n) {
    return nth_entry(edges, junction.position, junction.axis, direction, n);
  };
  const std::int32_t face_end = entry(junction.direction, (degree + 1) / 2);
  const std::int32_t edge_end = entry(-junction.direction, (degree - 1) / 2);
  return {junction, std::min(face_end, edge_end), std::max(face_end, edge_end)};
}

std::optional<std::pair<Extension, Extension>> crossing_extensions(const PlanarEdges& edges,
                                                                   const std::array<int, 2>& degree) {
  std::array<std::vector<Extension>, 2> extensions;
  for (const TJunction& junction : t_junctions(edges)) {
    extensions[junction.axis].push_back(extension(edges, junction, degree[junction.axis]));
  }
  for (const Extension& horizontal : extensions[0]) {
    for (const Extension& vertical : extensions[1]) {
      if (meet(horizontal, vertical)) return std::pair(horizontal, vertical);
    }
  }
  return std::nullopt;
}

std::optional<std::pair<TJunction, TJunction>> facing_junctions(const PlanarEdges& edges) {
  const std::vector<TJunction> junctions = t_junctions(edges);
  for (const TJunction& junction : junctions) {
    if (junction.direction < 0) continue;
    std::array<std::int32_t, 2> next = junction.position;
    next[junction.axis] = nth_entry(edges, next, junction.axis, +1, 1);
    const TJunction facing{next, junction.axis, -1};
    if (std::find(junctions.begin(), junctions.end(), facing) != junctions.end()) return std::pair(junction, facing);
  }
  return std::nullopt;
}

std::optional<std::vector<PlanarBox>> planar_boxes(const Mesh& mesh, Axis extruded) {
  const auto [first, second] = planar_axes(extruded);
  std::vector<std::vector<PlanarBox>> layers(mesh.coordinates[at(extruded)].size() - 1);
  for (const Box& element : mesh.elements) {
    const std::int32_t layer = element.lower[at(extruded)];
    if (element.upper[at(extruded)] != layer + 1) return std::nullopt;
    layers[at(layer)].push_back(
        {{element.lower[at(first)], element.lower[at(second)]}, {element.upper[at(first)], element.upper[at(second)]}});
  }
  for (std::vector<PlanarBox>& layer : layers) {
    std::sort(layer.begin(), layer.end(), by_box);
    if (layer != layers.front()) return std::nullopt;
  }
  return layers.front();
}

}  // namespace asts
