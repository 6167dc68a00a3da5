#include "properties/claims/mark_sets.hpp"

#include <algorithm>

#include "lib/gen/draw.hpp"

namespace asts {

namespace {

constexpr int kRandomSets = 5;

/// The setting and the levels in the tree's order tell all meshes of the class apart.
std::uint64_t seed_of(const RefinementTree& tree, const Elements& leaves) {
  std::uint64_t hash = 0xcbf29ce484222325U;  // FNV-1a
  const auto mix = [&](std::int32_t value) { hash = (hash ^ static_cast<std::uint32_t>(value)) * 0x100000001b3U; };
  mix(tree.setting().grading);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    mix(tree.setting().degree[axis]);
    mix(tree.setting().domain[axis]);
  }
  for (const std::int32_t leaf : leaves) mix(tree.node(leaf).level);
  return hash;
}

Elements of_level(const RefinementTree& tree, const Elements& leaves, std::int32_t level) {
  Elements result;
  std::copy_if(leaves.begin(), leaves.end(), std::back_inserter(result),
               [&](std::int32_t leaf) { return tree.node(leaf).level == level; });
  return result;
}

/// From two elements up to a third of the mesh.
Elements random_set(Draw& draw, const Elements& leaves, std::int32_t one_of_the_finest) {
  std::vector<bool> chosen(leaves.size(), false);
  const std::size_t most = draw.one_in(3) ? std::max<std::size_t>(leaves.size() / 3, 1) : 4;
  for (std::size_t count = draw.index(most) + 1; count > 0; --count) chosen[draw.index(leaves.size())] = true;
  Elements result;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (chosen[i] || leaves[i] == one_of_the_finest) result.push_back(leaves[i]);
  }
  return result;
}

}  // namespace

Elements leaves_in_order(const RefinementTree& tree) {
  Elements leaves;
  std::vector<std::int32_t> pending{0};
  while (!pending.empty()) {
    const std::int32_t id = pending.back();
    pending.pop_back();
    if (tree.is_leaf(id)) {
      leaves.push_back(id);
    } else {
      tree.push_children(id, pending);
    }
  }
  return leaves;
}

std::vector<Elements> mark_sets(const RefinementTree& tree) {
  const Elements leaves = leaves_in_order(tree);
  const Elements finest = of_level(tree, leaves, tree.max_level());
  std::vector<Elements> sets{{}, leaves, finest, of_level(tree, leaves, tree.node(0).coarsest)};
  Draw draw(seed_of(tree, leaves));
  for (int i = 0; i < kRandomSets; ++i) sets.push_back(random_set(draw, leaves, draw.choose(finest)));
  return sets;
}

}  // namespace asts
