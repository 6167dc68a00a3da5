#include "lib/spline/line_runs.hpp"

#include <algorithm>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

std::size_t at(std::int32_t id) { return static_cast<std::size_t>(id); }

/// Whether `next`, the node that stands behind `node` in the line order, prolongs its run.
bool continues(const TSplines& splines, Axis axis, std::int32_t node, std::int32_t next) {
  for (Axis other = 0; other < kDimension; ++other) {
    if (other == axis) continue;
    if (splines.nodes[at(node)][at(other)] != splines.nodes[at(next)][at(other)]) return false;
    if (splines.vector_ids[at(node)][at(other)] != splines.vector_ids[at(next)][at(other)]) return false;
  }
  return interiors_meet(splines.support(node, axis), splines.support(next, axis));
}

}  // namespace

LineRuns line_runs(const TSplines& splines, Axis axis, std::size_t max_pairs) {
  LineRuns result{axis, {}, {}};
  const std::vector<std::int32_t>& order = splines.line_order[at(axis)];
  for (std::int32_t i = 0; i < splines.size(); ++i) {
    const std::int32_t node = order[at(i)];
    if (i > 0 && continues(splines, axis, order[at(i - 1)], node)) {
      result.runs.back().end = i + 1;
      result.runs.back().support.upper[at(axis)] = splines.support(node, axis).upper;
      continue;
    }
    Box support;
    for (Axis other = 0; other < kDimension; ++other) {
      const RankInterval side = splines.support(node, other);
      support.lower[at(other)] = side.lower;
      support.upper[at(other)] = side.upper;
    }
    result.runs.push_back({i, i + 1, support});
  }
  std::vector<Box> boxes;
  boxes.reserve(result.runs.size());
  for (const LineRun& run : result.runs) boxes.push_back(run.support);
  for_each_meeting_pair(boxes, [&](std::int32_t i, std::int32_t j) {
    if (result.pairs.size() >= max_pairs) throw BudgetExhausted("more pairs of meeting supports than the budget allows");
    result.pairs.push_back(std::minmax(i, j));
  });
  return result;
}

}  // namespace asts
