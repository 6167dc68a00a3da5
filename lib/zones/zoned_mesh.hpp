#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lib/threads/apart.hpp"
#include "lib/zones/box_check.hpp"

namespace asts {

/// Decides three properties of the meshes of a growing refinement tree, zone by zone.
///
/// After a step. Say a mesh had a property, some elements were subdivided, and the new mesh does not have it. A
/// violation is about two nodes, or for analysis-suitability about a point and four nodes behind it (ZoneCheck). It is
/// none of the old mesh, so one of these nodes is new or has a new index vector. Hence boxes that contain the supports
/// of the changed nodes are enough.
class ZonedMesh {
 public:
  /// REQUIRES: the tree outlives it.
  explicit ZonedMesh(const RefinementTree& tree, const ZoneLimits& limits = {}) : zones_(tree, limits) {}
  ZonedMesh(const ZonedMesh&) = delete;
  ZonedMesh& operator=(const ZonedMesh&) = delete;

  /// What is proven of the tree's mesh, by so many threads. `subdivided` are the nodes of the tree that were subdivided
  /// since the last call; the first call does not look at them. REQUIRES: up-to-date ranks.
  /// Cost: linear in the elements the first time and after a mesh of which something was not proven; otherwise in the
  /// zones with changed nodes and the nodes that their supports touch.
  Proven decide(std::span<const std::int32_t> subdivided, int jobs = 1);

  /// The number of active nodes. REQUIRES: decide() was called.
  std::optional<std::int64_t> active_nodes() const;

 private:
  Proven check(const std::vector<RankBox>& boxes, bool changed_only, int jobs);

  Zones zones_;
  std::vector<Apart<BoxCheck>> checks_;  ///< one a thread
  std::optional<Proven> proven_;
};

}  // namespace asts
