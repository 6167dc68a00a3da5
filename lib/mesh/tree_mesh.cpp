#include <algorithm>

#include "lib/mesh/mesh.hpp"

namespace asts {

namespace {

/// The tree's leaves in the order of the tree.
std::vector<std::int32_t> leaves_in_order(const RefinementTree& tree) {
  std::vector<std::int32_t> leaves;
  leaves.reserve(static_cast<std::size_t>(tree.element_count()));
  std::vector<std::int32_t> pending{0};
  while (!pending.empty()) {
    const std::int32_t id = pending.back();
    pending.pop_back();
    if (tree.is_leaf(id)) {
      leaves.push_back(id);
      continue;
    }
    tree.push_children(id, pending);
  }
  return leaves;
}

/// The tree knows more lines than the mesh has (those of environments): numbers the mesh's lines, in their order, and
/// takes over their coordinates. Returns the mesh's rank of each of the tree's ranks.
std::vector<std::int32_t> adopt_lines(const RefinementTree& tree, const std::vector<std::int32_t>& leaves, Axis axis,
                                      Mesh& mesh) {
  const AxisGrid& grid = tree.grid(axis);
  std::vector<std::int32_t> rank(at(grid.line_count()), -1);
  for (const std::int32_t leaf : leaves) {
    const RankInterval extent = tree.extent(leaf, axis);
    rank[at(extent.lower)] = rank[at(extent.upper)] = 0;
  }
  std::vector<Rational>& coordinates = mesh.coordinates[at(axis)];
  for (std::int32_t tree_rank = 0; tree_rank < grid.line_count(); ++tree_rank) {
    if (rank[at(tree_rank)] < 0) continue;
    rank[at(tree_rank)] = static_cast<std::int32_t>(coordinates.size());
    coordinates.push_back(grid.coordinate(grid.line_of_rank(tree_rank)));
  }
  return rank;
}

/// The tree's own hierarchy, node for node; a leaf's element is filled in by the caller.
Locator locator_of(const RefinementTree& tree, const PerAxis<std::vector<std::int32_t>>& rank) {
  Locator locator;
  locator.nodes.assign(at(tree.node_count()), {-1, -1, 0, 0});
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.is_leaf(id)) continue;
    const Axis axis = tree.split_axis(id);
    const std::int32_t first = tree.node(id).first_child;
    const std::int32_t count = tree.child_count(id);
    Locator::Node& node = locator.nodes[at(id)];
    node.axis = axis;
    node.first = first;
    node.count = count;
    for (std::int32_t child = first; child < first + count; ++child) {
      locator.nodes[at(child)].lower = rank[at(axis)][at(tree.extent(child, axis).lower)];
    }
  }
  return locator;
}

}  // namespace

Mesh mesh_of(const RefinementTree& tree) {
  Mesh mesh;
  mesh.setting = tree.setting();
  const std::vector<std::int32_t> leaves = leaves_in_order(tree);
  PerAxis<std::vector<std::int32_t>> rank;
  for (Axis axis = 0; axis < kDimension; ++axis) rank[at(axis)] = adopt_lines(tree, leaves, axis, mesh);
  mesh.locator = locator_of(tree, rank);
  mesh.elements.reserve(leaves.size());
  mesh.levels.reserve(leaves.size());
  for (const std::int32_t leaf : leaves) {
    mesh.locator.nodes[at(leaf)].first = static_cast<std::int32_t>(mesh.elements.size());
    Box box;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const RankInterval extent = tree.extent(leaf, axis);
      box.lower[at(axis)] = rank[at(axis)][at(extent.lower)];
      box.upper[at(axis)] = rank[at(axis)][at(extent.upper)];
    }
    mesh.elements.push_back(box);
    mesh.levels.push_back(tree.node(leaf).level);
  }
  return mesh;
}

}  // namespace asts
