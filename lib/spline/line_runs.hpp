#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "lib/spline/box_pairs.hpp"
#include "lib/spline/tsplines.hpp"

namespace asts {

/// Active nodes that follow one another on a line parallel to an axis, have equal index vectors along the other axes,
/// and whose supports overlap one by one, so that their union is a box. Questions about pairs of nodes that concern
/// only the other axes are asked once for a pair of runs instead of for each pair of nodes.
struct LineRun {
  std::int32_t begin;  ///< into TSplines::line_order of the axis
  std::int32_t end;
  Box support;  ///< the union of the members' supports, in ranks
};

struct LineRuns {
  Axis axis;
  std::vector<LineRun> runs;
  /// All pairs i < j of runs whose closed supports meet, if only in a point; in no particular order.
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
};

/// Every active node is in exactly one run. Cost: linear in nodes, and a search for pairs of meeting boxes.
/// Throws BudgetExhausted when there are more than `max_pairs` pairs.
/// REQUIRES: all index vectors exist.
LineRuns line_runs(const TSplines& splines, Axis axis,
                   std::size_t max_pairs = std::numeric_limits<std::size_t>::max());

/// Whether two closed intervals of ranks have more than a point in common.
inline bool interiors_meet(const RankInterval& one, const RankInterval& other) {
  return one.lower < other.upper && other.lower < one.upper;
}

}  // namespace asts
