#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/refine/cluster_shape.hpp"
#include "lib/refine/node_table.hpp"

namespace asts {

/// Elements of one level, gathered in clusters, and the nodes of the tree above the clusters.
class Clusters {
 public:
  /// A node of the subtree that the roots span.
  struct Entry {
    Cluster cluster;   ///< no members for a node above the roots
    std::int32_t end;  ///< one past the last entry of the subtree, in preorder
    RankBox window;    ///< the bounding box of the environments (Definition 2.4) of the elements below
  };

  /// Cost: linear in the elements and the nodes above the clusters; elements of a cluster are gathered faster when they
  /// stand next to each other.
  /// `jobs` threads find the same as one.
  /// REQUIRES: distinct nodes of the shape's level, leaves or not; ranks are up to date.
  Clusters(const RefinementTree& tree, const ClusterShape& shape, std::span<const std::int32_t> elements, int jobs = 1);

  /// In preorder.
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  struct Path;

  void add_member(std::int32_t element, Path& path, std::vector<Cluster>& parts) const;
  void gather(std::span<const std::int32_t> elements, int jobs);
  void span_upwards();
  void list_entries();

  const RefinementTree& tree_;
  const ClusterShape& shape_;
  NodeTable spanned_;
  std::vector<std::uint64_t> members_;  ///< by the numbers of spanned_; the nodes above the roots follow
  std::vector<Entry> entries_;
};

}  // namespace asts
