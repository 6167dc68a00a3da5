#include "properties/claims/subdivision_step.hpp"

#include <algorithm>

#include "lib/spline/finer_lattice.hpp"
#include "lib/spline/perturbed_regions.hpp"
#include "lib/spline/slices.hpp"

namespace asts {

namespace {

/// K's box on the ranks of the hatted mesh.
Box box_of(const RefinementTree& tree, std::int32_t leaf, const Mesh& mesh) {
  Box box;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree.grid(axis);
    const RankInterval extent = tree.extent(leaf, axis);
    box.lower[at(axis)] = half_rank(mesh, axis, grid.coordinate(grid.line_of_rank(extent.lower))) / 2;
    box.upper[at(axis)] = half_rank(mesh, axis, grid.coordinate(grid.line_of_rank(extent.upper))) / 2;
  }
  return box;
}

/// The ranks of xi = x + j/m x~, j = 1..m-1.
std::vector<std::int32_t> new_lines(const SubdivisionStep& step) {
  const Axis axis = step.role(0);
  const Rational lower = step.lower(axis);
  const Rational size = step.upper(axis) - lower;
  std::vector<std::int32_t> lines;
  for (int j = 1; j < step.mesh.setting.grading; ++j) {
    lines.push_back(half_rank(step.mesh, axis, lower + size * j / step.mesh.setting.grading) / 2);
  }
  return lines;
}

/// A property of the nodes of G, said of the nodes of G^; false for the new ones. Both lists ascend.
std::vector<bool> on_new_nodes(const TSplines& before, const FinerLattice& lattice, const TSplines& after,
                               const std::vector<bool>& values) {
  std::vector<bool> result(after.nodes.size(), false);
  for (std::size_t i = 0; i < before.nodes.size(); ++i) {
    const auto place = std::lower_bound(after.nodes.begin(), after.nodes.end(), lattice.node(before.nodes[i]));
    result[static_cast<std::size_t>(place - after.nodes.begin())] = values[i];
  }
  return result;
}

bool projects_into(const PerAxis<std::int32_t>& node, const Box& element, Axis axis) {
  for (Axis other = 0; other < kDimension; ++other) {
    const auto o = at(other);
    if (other != axis && (node[o] < element.lower[o] || node[o] > element.upper[o])) return false;
  }
  return true;
}

template <class Select>
std::vector<Rectangle> slice_of(const SubdivisionStep& step, std::int32_t line, const Select& select) {
  std::vector<std::int32_t> nodes;
  for (std::int32_t node = 0; node < step.splines.size(); ++node) {
    if (select(at(node))) nodes.push_back(node);
  }
  return supports_in_slice(step.splines, step.role(0), 2 * line, nodes);
}

NewFace new_face(MeshUnderTest& before, const FinerLattice& lattice, const SubdivisionStep& step, std::int32_t line) {
  const Axis axis = step.role(0);
  NewFace face;
  face.line = line;
  const HalfRank old_place = half_rank(before.mesh(), axis, step.mesh.coordinate(axis, line));
  face.members = on_new_nodes(before.splines(), lattice, step.splines,
                              slice_nodes(before.mesh(), before.splines(), axis, old_place));
  face.hatted_members = slice_nodes(step.mesh, step.splines, axis, 2 * line);
  for (std::size_t node = 0; node < step.splines.nodes.size(); ++node) {
    face.projected.push_back(!step.is_new[node] && projects_into(step.splines.nodes[node], step.element, axis));
  }
  face.sigma = slice_of(step, line, [&](std::size_t node) { return step.is_new[node]; });
  face.large_sigma = slice_of(
      step, line, [&](std::size_t node) { return step.is_new[node] || (face.projected[node] && !face.members[node]); });
  return face;
}

}  // namespace

SubdivisionStep subdivision_step(MeshUnderTest& before, std::int32_t leaf) {
  RefinementTree tree = before.tree();
  SubdivisionStep step;
  step.level = tree.node(leaf).level;
  tree.subdivide(leaf);
  tree.update_ranks();
  step.mesh = mesh_of(tree);
  step.splines = tsplines_of(step.mesh);
  step.element = box_of(tree, leaf, step.mesh);
  step.hatted_regions = perturbed_regions(bricks_of(step.splines, before.pair_budget), step.splines.region);
  const FinerLattice lattice(before.mesh(), step.mesh);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    for (const Box& box : before.perturbed_regions()[axis]) step.regions[axis].push_back(lattice.box(box));
  }
  step.is_new =
      on_new_nodes(before.splines(), lattice, step.splines, std::vector<bool>(before.splines().nodes.size(), true));
  step.is_new.flip();
  for (const std::int32_t line : new_lines(step)) step.faces.push_back(new_face(before, lattice, step, line));
  return step;
}

bool reaches_active_nodes(MeshUnderTest& before, std::int32_t leaf) {
  return may_change_splines(before.splines(), box_of(before.tree(), leaf, before.mesh()),
                            before.tree().split_axis(leaf));
}

ElementInfo describe_step_element(const SubdivisionStep& step) {
  ElementInfo info;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    info.box.lower[at(axis)] = step.lower(axis);
    info.box.upper[at(axis)] = step.upper(axis);
  }
  info.level = step.level;
  return info;
}

}  // namespace asts
