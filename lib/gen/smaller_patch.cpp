#include "lib/gen/smaller_patch.hpp"

#include <algorithm>

#include "lib/gen/growing_case.hpp"

namespace asts {

namespace {

/// The coordinates of an axis's lines, by rank.
std::vector<Rational> coordinates_of(const AxisGrid& grid) {
  std::vector<Rational> coordinates;
  for (std::int32_t rank = 0; rank < grid.line_count(); ++rank) {
    coordinates.push_back(grid.coordinate(grid.line_of_rank(rank)));
  }
  return coordinates;
}

/// The smaller environment of an element along an axis: the widest interval between lines that an element must have
/// more than a point in common with to meet it.
RankInterval smaller_window(const std::vector<Rational>& lines, const RankInterval& side, int degree) {
  const Rational length = lines[at(side.upper)] - lines[at(side.lower)];
  const Rational reach = length * degree;  // p + 1/2 from the midpoint is p from either side
  const auto first_above = std::upper_bound(lines.begin(), lines.end(), lines[at(side.lower)] - reach);
  const auto first_from = std::lower_bound(lines.begin(), lines.end(), lines[at(side.upper)] + reach);
  const auto last = static_cast<std::int32_t>(lines.size()) - 1;
  return {std::max(0, static_cast<std::int32_t>(first_above - lines.begin()) - 1),
          std::min(last, static_cast<std::int32_t>(first_from - lines.begin()))};
}

}  // namespace

std::vector<std::int32_t> smaller_closure(const RefinementTree& tree, std::span<const std::int32_t> marks) {
  PerAxis<std::vector<Rational>> lines;
  for (Axis axis = 0; axis < kDimension; ++axis) lines[at(axis)] = coordinates_of(tree.grid(axis));
  std::vector<std::int32_t> closure(marks.begin(), marks.end());
  std::vector<std::int32_t> others;
  for (const std::int32_t leaf : leaves_of(tree)) {
    if (std::find(marks.begin(), marks.end(), leaf) == marks.end()) others.push_back(leaf);
  }
  for (std::size_t next = 0; next < closure.size(); ++next) {
    const std::int32_t element = closure[next];
    PerAxis<RankInterval> window;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      window[at(axis)] = smaller_window(lines[at(axis)], tree.extent(element, axis), tree.setting().degree[at(axis)]);
    }
    std::erase_if(others, [&](std::int32_t other) {
      bool joins = tree.node(other).level < tree.node(element).level;
      for (Axis axis = 0; joins && axis < kDimension; ++axis) {
        const RankInterval side = tree.extent(other, axis);
        joins = side.upper > window[at(axis)].lower && side.lower < window[at(axis)].upper;
      }
      if (joins) closure.push_back(other);
      return joins;
    });
  }
  return closure;
}

}  // namespace asts
