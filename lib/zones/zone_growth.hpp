#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lib/zones/new_faces.hpp"
#include "lib/zones/vector_store.hpp"
#include "lib/zones/zone.hpp"
#include "lib/zones/zone_nodes.hpp"

namespace asts {

/// What a step makes of a zone's nodes and index vectors.
///
/// Old nodes. Nodes stay when a mesh is refined. Their vectors along an axis change where the lines that they lie on
/// have new entries, and follow from the old vectors and these (insert_entries): nothing of the mesh is looked at.
/// New nodes. They are vertices of the split elements' children, and lie on the new faces: the part of the zone that
/// contains these is scanned (ZoneScanner).
/// The window. It has (p+1)/2 entries outside the zone on all lines through the zone, those of later nodes too, and
/// entries do not go: it stays.
///
/// Cost: linear in the zone's nodes, in the lines that the new faces cross, and that of scanning the part.
class ZoneGrowth {
 public:
  /// REQUIRES: both outlive it.
  ZoneGrowth(const RefinementTree& tree, std::vector<VectorStore>& stores, ZoneScanner& scanner)
      : tree_(&tree), stores_(&stores), scanner_(&scanner) {}

  /// Follows a step that split these elements, among others that change nothing in the zone, and marks the nodes that
  /// are new or have a new vector. False when that would take more lines or vectors than fit: then only the zone's node
  /// of the tree is of use, and the zone is to be found anew. REQUIRES: the zone is known and not empty; up-to-date
  /// ranks.
  bool follow(Zone& zone, std::span<const std::int32_t> split);

 private:
  /// Along an axis: the vectors of the zone, and the lines that its nodes lie on.
  struct Along {
    std::vector<std::int32_t> ranks;   ///< of these lines, ascending
    std::vector<std::int32_t> place;   ///< in these, by the number of a vector of old nodes
    std::vector<std::int32_t> number;  ///< of a vector in the zone, by identifier; -1 for others
    std::vector<std::int32_t> split;   ///< the elements that were split along this axis
  };

  /// A node that was found in a part of the zone, and how many of the zone's nodes come before it.
  struct Added {
    std::size_t node;
    std::size_t before;
  };

  void number_old(const Zone& zone, Axis axis);
  std::size_t vector_length(Axis axis) const { return at(tree_->setting().degree[at(axis)]) + 2; }
  std::uint16_t number_of(Zone& zone, Axis axis, std::int32_t id);
  void insert(Zone& zone, Axis axis);
  std::optional<RankBox> new_part(const Zone& zone, std::span<const std::int32_t> split) const;
  bool add_nodes(Zone& zone, const RankBox& part);
  std::vector<Added> new_among(const Zone& zone, const ZoneNodes& found) const;
  PerAxis<std::uint16_t> numbers_of(Zone& zone, const ZoneNodes& found, std::size_t node);
  void merge(Zone& zone, const ZoneNodes& found);
  void leave_out_unused(Zone& zone);

  const RefinementTree* tree_;
  std::vector<VectorStore>* stores_;
  ZoneScanner* scanner_;
  PerAxis<Along> along_;
  NewFaces faces_;
};

}  // namespace asts
