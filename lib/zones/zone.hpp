#pragma once

#include <cstdint>
#include <vector>

#include "lib/zones/rank_box.hpp"

namespace asts {

/// A part of a mesh: the box of a node of the refinement tree, with the active nodes that belong to it (ZoneScanner).
struct Zone {
  std::int32_t tree_node = 0;
  bool known = true;                           ///< false: too many lines for one word run through a single element
  bool empty = true;                           ///< does not meet the active region
  PerAxis<std::vector<std::int32_t>> vectors;  ///< distinct index vectors, identifiers in Zones::stores
  /// For each active node the places of its vectors in these; in the lexicographic order of (y,z,x).
  std::vector<PerAxis<std::uint16_t>> nodes;
  PerAxis<RankInterval> window;  ///< lines, not ranks: faces beyond them do not change the vectors
  std::vector<bool> changed;     ///< for each node whether the last update made or changed it; empty: none
};

}  // namespace asts
