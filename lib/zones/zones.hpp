#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "lib/zones/box_tree.hpp"
#include "lib/zones/vector_store.hpp"
#include "lib/zones/zone.hpp"
#include "lib/zones/zone_growth.hpp"
#include "lib/zones/zone_nodes.hpp"

namespace asts {

/// The active nodes and index vectors of the mesh of a growing refinement tree, zone by zone.
///
/// The domain is cut into zones of some thousand elements, so that what is worked on stays in the processor's cache and
/// the cost for an element does not depend on how many there are.
///
/// After a step only the zones that have changed nodes follow it (ZoneGrowth). An element that is subdivided along an
/// axis gets faces orthogonal to it: index vectors change along this axis only, of nodes whose zone has a window along
/// the axis that touches the element. A new node is a vertex of the element's children: its zone touches the element.
class Zones {
 public:
  /// REQUIRES: the tree outlives it; ranks are up to date at every call. Nothing is known before rebuild().
  explicit Zones(const RefinementTree& tree, const ZoneLimits& limits = {});

  /// From scratch, by so many threads. Cost: linear in elements.
  void rebuild(int jobs);

  /// After a step that subdivided these nodes of the tree: boxes (of ranks) that contain the supports of all nodes that
  /// are new or have a new index vector; these are marked as changed. Cost: that of the zones that may have any.
  std::vector<RankBox> update(std::span<const std::int32_t> subdivided);

  const ZoneLimits& limits() const { return limits_; }
  const RefinementTree& tree() const { return tree_; }
  const std::vector<Zone>& list() const { return zones_; }
  const std::vector<VectorStore>& stores() const { return stores_; }
  /// Finds zones by the hull of their nodes' supports.
  const BoxTree& supports() const { return supports_; }
  /// Whether all zones are known.
  bool known() const;
  std::int64_t active_nodes() const;

 private:
  /// By zone: the elements of a step that may change its nodes or vectors.
  using Affected = std::map<std::size_t, std::vector<std::int32_t>>;

  std::vector<std::int32_t> intern(Axis axis, const ZoneNodes& found);
  void scan(std::int32_t tree_node, std::vector<Zone>& zones);
  PerAxis<std::int32_t> position(const Zone& zone, const PerAxis<std::uint16_t>& node) const;
  RankBox support_hull(const Zone& zone) const;
  RankBox support(const Zone& zone, const PerAxis<std::uint16_t>& node) const;
  RankBox reach(const Zone& zone) const;
  void index_all();
  PerAxis<RankBox> reached_boxes(const Zone& zone) const;
  Affected affected_by(std::span<const std::int32_t> subdivided) const;
  std::vector<Zone> scan_again(const Zone& before);
  void divide(const Zone& zone, std::vector<Zone>& parts) const;
  bool divide_large(const Affected& affected);
  void replace(std::map<std::size_t, std::vector<Zone>>& replaced);
  std::optional<RankBox> changed_box(const Zone& zone) const;

  const RefinementTree& tree_;
  ZoneLimits limits_;
  std::vector<VectorStore> stores_;
  std::vector<Zone> zones_;  ///< in the order of the tree
  BoxTree supports_;
  BoxTree reaches_;
  ZoneScanner scanner_;
  ZoneGrowth growth_;
  std::vector<std::size_t> changed_;  ///< the zones with changed nodes
};

}  // namespace asts
