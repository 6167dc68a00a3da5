#include "lib/spline/axis_overlap.hpp"

#include <algorithm>
#include <optional>

#include "lib/exact/errors.hpp"

namespace asts {

bool AxisOverlap::holds(const Brick& one, const Brick& other) {
  const std::int32_t a = std::min(one.profile[at(axis_)], other.profile[at(axis_)]);
  const std::int32_t b = std::max(one.profile[at(axis_)], other.profile[at(axis_)]);
  if (a == b) return true;
  return known_.get(
      a, b, [&] { return overlap(bricks_.profile(one, axis_).entries, bricks_.profile(other, axis_).entries); });
}

std::int32_t index_with_entry(const TSplines& splines, const AxisProfile& profile, Axis axis, std::int32_t entry) {
  for (std::size_t i = 0; i < profile.vector_ids.size(); ++i) {
    const auto vector = splines.vectors[at(axis)][profile.vector_ids[i]];
    if (std::binary_search(vector.begin(), vector.end(), entry)) return static_cast<std::int32_t>(i);
  }
  throw InternalError("no index vector of the brick has the entry");
}

std::int32_t index_around(const TSplines& splines, const AxisProfile& profile, Axis axis, std::int32_t rank) {
  for (std::size_t i = 0; i < profile.vector_ids.size(); ++i) {
    const auto vector = splines.vectors[at(axis)][profile.vector_ids[i]];
    if (vector.front() <= rank && rank <= vector.back()) return static_cast<std::int32_t>(i);
  }
  throw InternalError("no index vector of the brick reaches the rank");
}

std::pair<std::int32_t, std::int32_t> indices_meeting(const TSplines& splines, const AxisProfile& one,
                                                      const AxisProfile& other, Axis axis) {
  const IndexVectors& vectors = splines.vectors[at(axis)];
  const auto side = [&](std::int32_t id) { return RankInterval{vectors.front(id), vectors.back(id)}; };
  std::optional<std::pair<std::int32_t, std::int32_t>> touching;
  for (std::size_t i = 0; i < one.vector_ids.size(); ++i) {
    for (std::size_t j = 0; j < other.vector_ids.size(); ++j) {
      const RankInterval first = side(one.vector_ids[i]);
      const RankInterval second = side(other.vector_ids[j]);
      const std::pair indices(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
      if (interiors_meet(first, second)) return indices;
      if (first.lower <= second.upper && second.lower <= first.upper) touching = indices;
    }
  }
  if (touching) return *touching;
  throw InternalError("no supports of the bricks meet");
}

}  // namespace asts
