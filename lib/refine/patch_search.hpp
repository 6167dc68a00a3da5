#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "lib/refine/cluster_reach.hpp"
#include "lib/refine/clusters.hpp"

namespace asts {

/// Finds the elements that are coarser than K in the patch of K (Definition 2.4, Algorithm 2.8, Definition 3.1), for
/// many elements K of one level at once.
///
/// How: the elements K in question are gathered in clusters of up to 64 (Clusters), the clusters span a subtree of the
/// refinement tree, and each of its nodes B has the bounding box W(B) of the environments U(K) below. The subtree is
/// walked from the root, with a list of candidates for each B: the nodes C, no smaller than B where possible, that
/// meet W(B) and have an unmarked leaf below that is coarser than the level in question. An empty list ends the walk
/// below B. At a cluster the search goes down from its candidates to the leaves, and asks at each node which members'
/// environments it meets, all of them at once, as bits of a word (ClusterReach).
///
/// Cost: linear in the elements K, the nodes above the clusters and the pairs (B, C) and (cluster, C) met. A node C is
/// looked at only if a leaf below is coarser than K, unmarked, and meets W(B), so that elements whose surroundings are
/// fine enough cost nothing beyond their share of the nodes above; in Algorithm 2.8 the caller marks each leaf found,
/// and it is left out from then on. A cell of a patch is never visited for its own sake: where the degree is p, the
/// patch of one K has up to (2p+3)^3 elements of its own level, and none of them is looked at. Nothing depends on the
/// size of the mesh, nor is a history assumed: levels may jump arbitrarily.
class PatchSearch {
 public:
  /// C, an unmarked leaf, and the members K of a cluster with level(C) < level(K) whose open U(K) it meets.
  struct Coarser {
    std::int32_t leaf;
    std::int32_t entry;  ///< of the clusters
    Cluster too_fine;    ///< the elements K, of the shape's level
    const RefinementTree& tree;
    const ClusterShape& shape;

    int first_bit() const { return std::countr_zero(too_fine.members); }
    /// The first K in the order of the tree.
    std::int32_t element() const { return shape.member(tree, too_fine.root, first_bit()); }

    template <typename Visit>
    void for_each_element(const Visit& visit) const {
      for (std::uint64_t rest = too_fine.members; rest != 0; rest &= rest - 1) {
        visit(shape.member(tree, too_fine.root, std::countr_zero(rest)));
      }
    }
  };
  /// Returns false to end the search.
  using Found = std::function<bool(const Coarser&)>;

  /// REQUIRES: the tree's ranks are up to date at every search.
  explicit PatchSearch(const RefinementTree& tree) : tree_(tree) {}

  /// Searches for all `elements`, which are nodes of level `level` without repetition, leaves or not. For each cluster
  /// each C is found once, with all K of the cluster whose environments it meets; the clusters come in the order of the
  /// tree, within a cluster the C by the first such K, then by themselves, in that order. `found` may mark the leaf
  /// that it is given. Returns false when `found` ended the search.
  bool coarser_in_patches(std::span<const std::int32_t> elements, std::int32_t level, const Found& found);

  /// The same for clusters that are made already, among the leaves below one node only.
  bool coarser_below(std::int32_t top, const ClusterShape& shape, const Clusters& clusters, const Found& found);

 private:
  /// A node and the members of the cluster whose environments it meets, along each axis.
  struct Hit {
    std::int32_t node;
    std::int32_t first_child;
    std::int32_t level;
    PerAxis<std::uint64_t> along;

    std::uint64_t members() const { return along[0] & along[1] & along[2]; }
  };
  /// A leaf, ordered by the first member that it is too coarse for, then as in the tree.
  struct Leaf {
    std::uint64_t order;
    std::int32_t node;
    std::uint64_t members;
  };

  bool reaches(std::int32_t candidate, const RankBox& window) const;
  void collect_candidates(const Clusters::Entry& entry, std::size_t from, std::size_t to);
  bool report_leaves(const ClusterShape& shape, const Clusters& clusters, std::int32_t number, std::size_t from,
                     const Found& found);
  void start_from(std::int32_t candidate);
  void push_children(const Hit& hit);
  void collect_leaves(std::size_t from);

  const RefinementTree& tree_;
  std::int32_t level_ = 0;
  ClusterReach reach_;
  std::vector<std::int32_t> candidates_;
  std::vector<std::int32_t> pending_;
  std::vector<Hit> hits_;
  std::vector<Hit> deeper_hits_;
  std::vector<Leaf> leaves_;
};

}  // namespace asts
