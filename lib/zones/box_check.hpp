#pragma once

#include <vector>

#include "lib/zones/zone_check.hpp"
#include "lib/zones/zones.hpp"

namespace asts {

/// Looks for violations at the points of closed boxes, given the zones of a mesh. One object a thread.
class BoxCheck {
 public:
  /// REQUIRES: the zones outlive it.
  explicit BoxCheck(const Zones& zones) : zones_(zones), check_(zones.tree(), zones.stores(), zones.limits()) {}

  /// What is proven at the points of a box of ranks (ZoneCheck), of all nodes or of the changed ones. Where too many
  /// lines run through it, it is cut in two. Cost: linear in the nodes of the zones whose supports may touch the box,
  /// and that of ZoneCheck.
  Proven decide(const RankBox& box, bool changed_only);

 private:
  void gather(const RankBox& box, bool changed_only);
  void number_vectors(const Zone& zone, const RankBox& box);

  const Zones& zones_;
  ZoneCheck check_;
  PerAxis<std::vector<std::int32_t>> numbers_;  ///< of all vectors in the check at hand, -1 for others
  PerAxis<std::vector<std::int32_t>> of_zone_;  ///< of the vectors of one zone
};

}  // namespace asts
