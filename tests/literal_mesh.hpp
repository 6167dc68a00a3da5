#pragma once

#include <algorithm>
#include <vector>

#include "lib/mesh/case.hpp"
#include "lib/mesh/mesh.hpp"
#include "tests/reference/refine.hpp"

/// The bridge between lib's types and those of the literal reference, for tests that compare the two.
namespace asts::literal {

inline reference::Setting setting(const Setting& setting) { return {setting.degree, setting.grading, setting.domain}; }

inline reference::Point point(const Point& point) {
  reference::Point result;
  for (std::size_t axis = 0; axis < kDimension; ++axis) result[axis] = point[axis].value();
  return result;
}

inline reference::Box box(const Mesh& mesh, const Box& element) {
  reference::Box result;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    result.lower[a] = mesh.coordinate(axis, element.lower[a]);
    result.upper[a] = mesh.coordinate(axis, element.upper[a]);
  }
  return result;
}

inline reference::Box box(const RefinementTree& tree, std::int32_t id) {
  reference::Box result;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree.grid(axis);
    const RankInterval extent = tree.extent(id, axis);
    result.lower[static_cast<std::size_t>(axis)] = grid.coordinate(grid.line_of_rank(extent.lower));
    result.upper[static_cast<std::size_t>(axis)] = grid.coordinate(grid.line_of_rank(extent.upper));
  }
  return result;
}

/// The boxes of a mesh of lib, in order.
inline reference::Mesh mesh(const Mesh& mesh) {
  reference::Mesh result;
  for (const Box& element : mesh.elements) result.push_back(box(mesh, element));
  return result;
}

/// As a set.
inline reference::Mesh sorted(reference::Mesh mesh) {
  std::sort(mesh.begin(), mesh.end());
  return mesh;
}

/// One step by the literal algorithms alone.
inline reference::Mesh after_step(const reference::Setting& setting, const reference::Mesh& mesh, const Step& step) {
  std::vector<std::size_t> marked;
  for (const Point& mark : step.marks) marked.push_back(reference::element_at(setting, mesh, point(mark)).value());
  return step.kind == Step::Kind::refine ? reference::refine(setting, mesh, marked)
                                         : reference::subdivide(setting, mesh, marked);
}

/// A case's last mesh by the literal algorithms alone.
inline reference::Mesh last_mesh(const Case& test_case) {
  const reference::Setting literal_setting = setting(setting_of(test_case));
  reference::Mesh result;
  for (const ElementLine& line : test_case.elements) result.push_back({point(line.lower), point(line.upper)});
  if (test_case.explicit_mesh) return result;
  result = reference::initial_mesh(literal_setting);
  for (const Step& step : test_case.steps) result = after_step(literal_setting, result, step);
  return result;
}

}  // namespace asts::literal
