#include "lib/spline/index_sets.hpp"

#include <algorithm>

namespace asts {

HalfRank half_rank(const Mesh& mesh, Axis axis, const Rational& coordinate) {
  const std::vector<Rational>& lines = mesh.coordinates[at(axis)];
  const auto place = std::lower_bound(lines.begin(), lines.end(), coordinate);
  const auto rank = static_cast<std::int32_t>(place - lines.begin());
  return place != lines.end() && *place == coordinate ? 2 * rank : 2 * rank - 1;
}

LineWalker::LineWalker(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& position, int direction)
    : mesh_(mesh), axis_(at(axis)), direction_(direction), rank_(position[at(axis)] / 2) {
  cells_.fill({});
  for (std::size_t other = 0; other < kDimension; ++other) {
    if (other == axis_) continue;
    const std::int32_t rank = position[other] / 2;
    const auto cells = static_cast<std::int32_t>(mesh.coordinates[other].size()) - 1;
    const bool below = position[other] % 2 == 0 && rank > 0;
    const bool above = rank < cells;
    for (std::size_t quadrant = 0; quadrant < quadrants_; ++quadrant) {
      cells_[quadrant][other] = above ? rank : rank - 1;
      if (!below || !above) continue;
      cells_[quadrants_ + quadrant] = cells_[quadrant];
      cells_[quadrants_ + quadrant][other] = rank - 1;
    }
    if (below && above) quadrants_ *= 2;
  }
  ends_.fill(rank_);
}

void LineWalker::enter_elements() {
  for (std::size_t quadrant = 0; quadrant < quadrants_; ++quadrant) {
    if (ends_[quadrant] != rank_) continue;
    cells_[quadrant][axis_] = direction_ > 0 ? rank_ : rank_ - 1;
    ends_[quadrant] = end_of(mesh_.locator.element_at(cells_[quadrant]));
  }
}

std::int32_t LineWalker::end_of(std::int32_t element) const {
  const Box& box = mesh_.elements[at(element)];
  return direction_ > 0 ? box.upper[axis_] : box.lower[axis_];
}

std::int32_t LineWalker::next() {
  const auto last = static_cast<std::int32_t>(mesh_.coordinates[axis_].size()) - 1;
  if (rank_ == (direction_ > 0 ? last : 0)) return -1;
  enter_elements();
  const auto begin = ends_.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(quadrants_);
  rank_ = direction_ > 0 ? *std::min_element(begin, end) : *std::max_element(begin, end);
  return rank_;
}

std::vector<std::int32_t> global_index_set(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& position) {
  PerAxis<HalfRank> start = position;
  start[at(axis)] = 0;
  LineWalker walker(mesh, axis, start, +1);
  std::vector<std::int32_t> entries{0};
  for (std::int32_t rank = walker.next(); rank >= 0; rank = walker.next()) entries.push_back(rank);
  return entries;
}

}  // namespace asts
