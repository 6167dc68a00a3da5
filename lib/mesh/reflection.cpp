#include "lib/mesh/reflection.hpp"

namespace asts {

std::array<PerAxis<bool>, 7> reflections() {
  static_assert(kDimension == 3, "2^3 - 1 reflections");
  std::array<PerAxis<bool>, 7> result{};
  for (std::size_t set = 1; set <= result.size(); ++set) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) result[set - 1][axis] = (set >> axis & 1U) != 0;
  }
  return result;
}

namespace {

/// Where the unit cubes go. The blocks above them are no mirror images of each other when a side is odd.
void match_unit_cubes(const RefinementTree& tree, const PerAxis<bool>& axes, Reflection& result) {
  const PerAxis<int>& domain = tree.setting().domain;
  PerAxis<std::int32_t> cube{};
  while (true) {
    PerAxis<std::int32_t> mirrored = cube;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if (axes[axis]) mirrored[axis] = domain[axis] - 1 - cube[axis];
    }
    result.image[at(tree.unit_cube(cube))] = result.tree.unit_cube(mirrored);
    std::size_t axis = 0;
    while (axis < kDimension && ++cube[axis] == domain[axis]) cube[axis++] = 0;
    if (axis == kDimension) return;
  }
}

}  // namespace

Reflection reflect(const RefinementTree& tree, const PerAxis<bool>& axes) {
  Reflection result{RefinementTree(tree.setting()),
                    std::vector<std::int32_t>(at(tree.node_count()), RefinementTree::kNone)};
  match_unit_cubes(tree, axes, result);
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {  // parents have lower ids than their children
    if (tree.node(id).level < 0 || tree.is_leaf(id)) continue;
    const std::int32_t image = result.image[at(id)];
    result.tree.subdivide(image);
    const std::int32_t first = tree.node(id).first_child;
    const std::int32_t image_first = result.tree.node(image).first_child;
    const std::int32_t last = tree.child_count(id) - 1;
    const bool mirrored = axes[at(tree.split_axis(id))];
    for (std::int32_t j = 0; j <= last; ++j) result.image[at(first + j)] = image_first + (mirrored ? last - j : j);
  }
  result.tree.update_ranks();
  return result;
}

}  // namespace asts
