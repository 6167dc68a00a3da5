#pragma once

#include <cstdint>
#include <vector>

#include "properties/mesh_under_test.hpp"
#include "properties/witness.hpp"

namespace asts {

/// The elements of a mesh in the class with their patches (Definition 2.4), each decided by asking all elements.
/// Cost: quadratic in the elements, a few comparisons of ranks a pair.
class LeafPatches {
 public:
  /// REQUIRES: every element of the mesh is in the class of Definition 2.6; the tree outlives this.
  explicit LeafPatches(const MeshUnderTest& mesh);

  std::size_t size() const { return leaves_.size(); }
  /// The tree's node of an element.
  std::int32_t node(std::size_t leaf) const { return leaves_[leaf]; }
  std::int32_t level(std::size_t leaf) const { return tree_->node(leaves_[leaf]).level; }
  const ExactPoint& midpoint(std::size_t leaf) const { return midpoints_[leaf]; }

  /// Whether `other` belongs to the patch of `leaf`: the closed element meets the open environment.
  bool in_patch(std::size_t leaf, std::size_t other) const;

  /// Algorithm 2.8 for one marked element: the closure, the mark first.
  std::vector<std::size_t> closure(std::size_t mark) const;

 private:
  const RefinementTree* tree_;
  std::vector<std::int32_t> leaves_;
  std::vector<ExactPoint> midpoints_;
  std::vector<std::vector<std::size_t>> coarser_;  ///< the coarser elements in each one's patch
};

}  // namespace asts
