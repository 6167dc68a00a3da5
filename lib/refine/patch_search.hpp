#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// Finds the elements that are coarser than K in the patch of K (Definition 2.4, Algorithm 2.8, Definition 3.1), for
/// many elements K of one level at once.
///
/// How: the elements K in question span a subtree of the refinement tree, and each of its nodes B gets the bounding
/// box W(B) of the environments U(K) below. The subtree is walked from the root, with a list of candidates for each B:
/// the nodes C, no smaller than B where possible, that meet W(B) and have an unmarked leaf below that is coarser than
/// the level in question. An empty list ends the walk below B, so that elements whose surroundings are fine enough
/// cost nothing beyond their share of the blocks. No cell of a patch is visited unless a coarse leaf lies there.
///
/// Cost: linear in the walked subtree and the pairs (B, C) met. Each leaf found is marked by the caller in Algorithm
/// 2.8, and is left out from then on.
class PatchSearch {
 public:
  /// `found(K, C)`: C is an unmarked leaf with level(C) < level(K) that meets the open box U(K). Returns false to end
  /// the search.
  using Found = std::function<bool(std::int32_t element, std::int32_t coarser)>;

  /// REQUIRES: the tree's ranks are up to date at every search.
  explicit PatchSearch(const RefinementTree& tree) : tree_(tree) {}

  /// Searches for all `elements`, which are nodes of level `level` without repetition, leaves or not. For one K the
  /// order is that of the tree. `found` may mark leaves. Returns false when `found` ended the search.
  bool coarser_in_patches(std::span<const std::int32_t> elements, std::int32_t level, const Found& found);

 private:
  struct Extent {
    PerAxis<RankInterval> side;
  };
  struct Entry {
    std::int32_t node;
    std::int32_t end;  ///< one past the last entry of the subtree, in preorder
    Extent window;
  };

  void span_subtree(std::span<const std::int32_t> elements);
  void append_entries(std::int32_t level);
  void collect_candidates(const Entry& entry, std::size_t from, std::size_t to);
  bool report_leaves(const Entry& entry, std::size_t from, const Found& found);
  bool reaches(std::int32_t candidate, const Extent& window) const;

  const RefinementTree& tree_;
  std::int32_t level_ = 0;
  std::uint32_t epoch_ = 0;
  std::vector<std::uint32_t> stamp_;
  std::vector<Entry> entries_;
  std::vector<std::int32_t> candidates_;
  std::vector<std::int32_t> pending_;
};

}  // namespace asts
