#include "lib/spline/index_sets.hpp"

#include <algorithm>

namespace asts {

namespace {

std::size_t at(std::int32_t id) { return static_cast<std::size_t>(id); }

}  // namespace

HalfRank half_rank(const Mesh& mesh, Axis axis, const Rational& coordinate) {
  const std::vector<Rational>& lines = mesh.coordinates[at(axis)];
  const auto place = std::lower_bound(lines.begin(), lines.end(), coordinate);
  const auto rank = static_cast<std::int32_t>(place - lines.begin());
  return place != lines.end() && *place == coordinate ? 2 * rank : 2 * rank - 1;
}

LineWalker::LineWalker(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& position)
    : mesh_(mesh), axis_(at(axis)), last_rank_(static_cast<std::int32_t>(mesh.coordinates[at(axis)].size()) - 1) {
  quadrants_.push_back({});
  for (std::size_t other = 0; other < kDimension; ++other) {
    if (other == axis_) continue;
    const std::int32_t rank = position[other] / 2;
    const auto cells = static_cast<std::int32_t>(mesh.coordinates[other].size()) - 1;
    std::vector<std::int32_t> intervals;
    const bool on_line = position[other] % 2 == 0;
    if (on_line && rank > 0) intervals.push_back(rank - 1);
    if (rank < cells) intervals.push_back(rank);
    std::vector<PerAxis<std::int32_t>> product;
    for (PerAxis<std::int32_t> cell : quadrants_) {
      for (const std::int32_t interval : intervals) {
        cell[other] = interval;
        product.push_back(cell);
      }
    }
    quadrants_ = std::move(product);
  }
}

std::int32_t LineWalker::element_beside(std::size_t quadrant, std::int32_t interval) const {
  PerAxis<std::int32_t> cell = quadrants_[quadrant];
  cell[axis_] = interval;
  return mesh_.locator.element_at(cell);
}

bool LineWalker::crosses(std::int32_t rank) const {
  if (rank == 0 || rank == last_rank_) return true;
  for (std::size_t quadrant = 0; quadrant < quadrants_.size(); ++quadrant) {
    if (mesh_.elements[at(element_beside(quadrant, rank))].lower[axis_] == rank) return true;
  }
  return false;
}

std::int32_t LineWalker::next(std::int32_t rank, int direction) const {
  if (rank == (direction > 0 ? last_rank_ : 0)) return -1;
  std::int32_t nearest = direction > 0 ? last_rank_ : 0;
  for (std::size_t quadrant = 0; quadrant < quadrants_.size(); ++quadrant) {
    const Box& box = mesh_.elements[at(element_beside(quadrant, direction > 0 ? rank : rank - 1))];
    nearest = direction > 0 ? std::min(nearest, box.upper[axis_]) : std::max(nearest, box.lower[axis_]);
  }
  return nearest;
}

std::vector<std::int32_t> global_index_set(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& position) {
  const LineWalker walker(mesh, axis, position);
  std::vector<std::int32_t> entries{0};
  for (std::int32_t rank = walker.next(0, +1); rank >= 0; rank = walker.next(rank, +1)) entries.push_back(rank);
  return entries;
}

}  // namespace asts
