#pragma once

#include <vector>

#include "fuzz/validation/literal_case.hpp"
#include "tests/reference/refine.hpp"

/// More of the bridge between lib's types and those of the literal reference, for tests that compare the two.
namespace asts::literal {

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
  if (test_case.explicit_mesh) return boxes(test_case);
  reference::Mesh result = reference::initial_mesh(literal_setting);
  for (const Step& step : test_case.steps) result = after_step(literal_setting, result, step);
  return result;
}

}  // namespace asts::literal
