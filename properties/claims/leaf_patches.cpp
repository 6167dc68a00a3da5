#include "properties/claims/leaf_patches.hpp"

#include "properties/claims/family_facts.hpp"
#include "properties/describe.hpp"

namespace asts {

LeafPatches::LeafPatches(const MeshUnderTest& mesh) : tree_(&mesh.tree()) {
  for (const std::int32_t id : mesh.tree_elements()) {
    if (!tree_->is_leaf(id)) continue;
    leaves_.push_back(id);
    midpoints_.push_back(asts::midpoint(describe_tree_element(*tree_, id).box));
  }
  coarser_.resize(size());
  for (std::size_t leaf = 0; leaf < size(); ++leaf) {
    for (std::size_t other = 0; other < size(); ++other) {
      if (level(other) < level(leaf) && in_patch(leaf, other)) coarser_[leaf].push_back(other);
    }
  }
}

bool LeafPatches::in_patch(std::size_t leaf, std::size_t other) const {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval open = tree_->environment(node(leaf), axis);
    const RankInterval closed = tree_->extent(node(other), axis);
    if (closed.lower >= open.upper || closed.upper <= open.lower) return false;
  }
  return true;
}

std::vector<std::size_t> LeafPatches::closure(std::size_t mark) const {
  std::vector<std::size_t> result{mark};
  std::vector<bool> marked(size(), false);
  marked[mark] = true;
  for (std::size_t done = 0; done < result.size(); ++done) {
    for (const std::size_t other : coarser_[result[done]]) {
      if (marked[other]) continue;
      marked[other] = true;
      result.push_back(other);
    }
  }
  return result;
}

}  // namespace asts
