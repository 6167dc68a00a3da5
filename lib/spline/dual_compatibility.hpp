#pragma once

#include <cstdint>
#include <optional>

#include "lib/spline/line_runs.hpp"

namespace asts {

/// A pair of active nodes, by their numbers in TSplines.
struct NodePair {
  std::int32_t v;
  std::int32_t w;

  friend auto operator<=>(const NodePair&, const NodePair&) = default;
};

/// Definition 6.4: a mesh is dual-compatible if any two active nodes whose supports' intersection has positive volume
/// partially overlap (Definition 6.3: their index vectors overlap along at least two of the three axes). Returns the
/// least pair v < w that does not, or nothing if the mesh is dual-compatible.
///
/// Along the two axes across the runs, all nodes of a run have the same index vectors, so that a pair of runs is asked
/// once: if both axes overlap, all pairs of their nodes partially overlap, whatever happens along the runs.
/// Cost: linear in the pairs of runs, and in the pairs of nodes of those runs that fail to overlap across.
/// REQUIRES: runs of these splines, along any axis.
std::optional<NodePair> find_incompatible(const TSplines& splines, const LineRuns& runs);

}  // namespace asts
