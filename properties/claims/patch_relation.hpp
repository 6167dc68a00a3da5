#pragma once

#include <functional>

#include "properties/claims/mark_sets.hpp"

namespace asts {

/// Whether an element of the mesh belongs to the patch of K (Definition 2.4).
using InPatch = std::function<bool(const RefinementTree& tree, std::int32_t k, std::int32_t element)>;

/// Definition 2.4, as it stands: the closed element meets the open environment U(K), that is, their interiors meet.
bool in_patch(const RefinementTree& tree, std::int32_t k, std::int32_t element);

/// The coarser elements in the patch of each element of a mesh: what Algorithm 2.8 adds for it. Found by asking all
/// pairs, which is what the claims about the search in lib/refine are to be compared with.
class CoarserInPatches {
 public:
  explicit CoarserInPatches(const RefinementTree& tree);

  /// The mesh, in the tree's order.
  const Elements& leaves() const { return leaves_; }
  /// REQUIRES: a leaf.
  const Elements& of(std::int32_t leaf) const { return coarser_[at(leaf)]; }
  std::size_t node_count() const { return coarser_.size(); }

 private:
  Elements leaves_;
  std::vector<Elements> coarser_;  ///< by node
};

/// The least superset of the marks with: if it has K, it has all coarser elements in the patch of K. It consists of all
/// that a chain of such steps reaches from a mark: every closed superset has these, and they are closed. Ascending.
Elements least_closed_superset(const CoarserInPatches& patches, const Elements& marks);

/// Algorithm 2.8 as printed: the loop over M~ goes through the elements in this order, those added meanwhile included
/// when their turn is still to come, until M~ stops growing. Ascending.
Elements closure_as_printed(const CoarserInPatches& patches, const Elements& marks, const Elements& order);

}  // namespace asts
