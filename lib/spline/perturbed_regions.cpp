#include "lib/spline/perturbed_regions.hpp"

#include <algorithm>
#include <numeric>

#include "lib/exact/errors.hpp"
#include "lib/spline/axis_overlap.hpp"
#include "lib/spline/rectangles.hpp"
#include "lib/spline/slices.hpp"

namespace asts {

namespace {

/// The bricks that reach each slice of an axis, and whether they have its line as an entry.
class Slices {
 public:
  Slices(const Bricks& bricks, Axis axis, const ActiveRegion& within) : bricks_(bricks), axis_(axis), within_(within) {
    const std::size_t a = at(axis);
    first_ = (within.lower[a] + 1) / 2;
    const std::int32_t last = within.upper[a] / 2;
    begin_.assign(at(std::max(last - first_ + 1, 0)) + 1, 0);
    for_each_visit([&](std::size_t slice, std::int32_t, bool) { ++begin_[slice + 1]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    visits_.resize(begin_.back());
    std::vector<std::size_t> next = begin_;
    for_each_visit([&](std::size_t slice, std::int32_t brick, bool has) { visits_[next[slice]++] = 2 * brick + has; });
  }

  std::size_t count() const { return begin_.size() - 1; }
  HalfRank position(std::size_t slice) const { return 2 * (first_ + static_cast<std::int32_t>(slice)); }

  /// The rectangles of the bricks that have the slice's line, or of those that reach it without having it.
  void rectangles(std::size_t slice, bool has, std::vector<Rectangle>& result) const {
    result.clear();
    for (std::size_t i = begin_[slice]; i < begin_[slice + 1]; ++i) {
      if ((visits_[i] & 1) == static_cast<std::int32_t>(has)) add_rectangle(bricks_.bricks[at(visits_[i] / 2)], result);
    }
  }

 private:
  template <typename Visit>
  void for_each_visit(const Visit& visit) const {
    const auto count = static_cast<std::int32_t>(begin_.size()) - 1;
    for (std::int32_t id = 0; id < static_cast<std::int32_t>(bricks_.bricks.size()); ++id) {
      const Brick& brick = bricks_.bricks[at(id)];
      const std::vector<std::int32_t>& entries = bricks_.profile(brick, axis_).entries;
      const std::int32_t lower = std::max(brick.support.lower[at(axis_)], first_);
      const std::int32_t upper = std::min(brick.support.upper[at(axis_)], first_ + count - 1);
      auto entry = std::lower_bound(entries.begin(), entries.end(), lower);
      for (std::int32_t rank = lower; rank <= upper; ++rank) {
        const bool has = entry != entries.end() && *entry == rank;
        if (has) ++entry;
        visit(at(rank - first_), id, has);
      }
    }
  }

  void add_rectangle(const Brick& brick, std::vector<Rectangle>& result) const {
    Rectangle rectangle{};
    std::size_t side = 0;
    for (Axis other = 0; other < kDimension; ++other) {
      if (other == axis_) continue;
      rectangle.lower[side] = std::max(2 * brick.support.lower[at(other)], within_.lower[at(other)]);
      rectangle.upper[side] = std::min(2 * brick.support.upper[at(other)], within_.upper[at(other)]);
      if (rectangle.lower[side] > rectangle.upper[side]) return;
      ++side;
    }
    result.push_back(rectangle);
  }

  const Bricks& bricks_;
  Axis axis_;
  const ActiveRegion& within_;
  std::int32_t first_ = 0;            ///< the rank of the first slice
  std::vector<std::size_t> begin_;    ///< of each slice's visits
  std::vector<std::int32_t> visits_;  ///< twice the brick, plus 1 if it has the line
};

std::optional<PerAxis<HalfRank>> least_common_point(const std::vector<Box>& first, const std::vector<Box>& second) {
  std::optional<PerAxis<HalfRank>> least;
  for_each_meeting_pair(first, second, [&](std::int32_t i, std::int32_t j) {
    PerAxis<HalfRank> point;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      point[axis] = std::max(first[at(i)].lower[axis], second[at(j)].lower[axis]);
    }
    if (!least || point < *least) least = point;
  });
  return least;
}

/// The first index of a brick whose support contains a position along an axis, if there is one.
std::optional<std::int32_t> index_covering(const TSplines& splines, const AxisProfile& profile, Axis axis,
                                           HalfRank position) {
  const IndexVectors& vectors = splines.vectors[at(axis)];
  for (std::size_t i = 0; i < profile.vector_ids.size(); ++i) {
    const std::int32_t id = profile.vector_ids[i];
    if (2 * vectors.front(id) <= position && position <= 2 * vectors.back(id)) return static_cast<std::int32_t>(i);
  }
  return std::nullopt;
}

/// A node of a brick whose support contains a point, if there is one.
std::optional<std::int32_t> node_covering(const TSplines& splines, const Bricks& bricks, const Brick& brick,
                                          const PerAxis<HalfRank>& point) {
  PerAxis<std::int32_t> index;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto found = index_covering(splines, bricks.profile(brick, axis), axis, point[at(axis)]);
    if (!found) return std::nullopt;
    index[at(axis)] = *found;
  }
  return bricks.node(brick, index);
}

}  // namespace

std::vector<Box> perturbed_region(const Bricks& bricks, Axis axis, const ActiveRegion& within) {
  std::vector<Box> region;
  const Slices slices(bricks, axis, within);
  UnionIntersection intersection;
  std::vector<Rectangle> having;
  std::vector<Rectangle> lacking;
  for (std::size_t slice = 0; slice < slices.count(); ++slice) {
    slices.rectangles(slice, true, having);
    slices.rectangles(slice, false, lacking);
    if (having.empty() || lacking.empty()) continue;
    for (const Rectangle& rectangle : intersection.of(having, lacking)) {
      region.push_back(box_in_slice(axis, slices.position(slice), rectangle));
    }
  }
  return region;
}

std::vector<Box> perturbed_region(const TSplines& splines, const Bricks& bricks, Axis axis) {
  return perturbed_region(bricks, axis, splines.region);
}

PerturbedRegions perturbed_regions(const Bricks& bricks, const ActiveRegion& within) {
  PerturbedRegions regions;
  for (Axis axis = 0; axis < kDimension; ++axis) regions[at(axis)] = perturbed_region(bricks, axis, within);
  return regions;
}

std::optional<RegionsMeet> find_meeting(const PerturbedRegions& regions) {
  for (Axis first = 0; first < kDimension; ++first) {
    for (Axis second = first + 1; second < kDimension; ++second) {
      if (const auto point = least_common_point(regions[at(first)], regions[at(second)])) {
        return RegionsMeet{first, second, *point};
      }
    }
  }
  return std::nullopt;
}

std::optional<RegionsMeet> find_meeting_regions(const TSplines& splines, const Bricks& bricks) {
  return find_meeting(perturbed_regions(bricks, splines.region));
}

std::pair<std::int32_t, std::int32_t> nodes_behind(const TSplines& splines, const Bricks& bricks, Axis axis,
                                                   const PerAxis<HalfRank>& point) {
  std::optional<std::int32_t> in;
  std::optional<std::int32_t> out;
  for (const Brick& brick : bricks.bricks) {
    const auto node = node_covering(splines, bricks, brick, point);
    if (!node) continue;
    const auto vector = splines.index_vector(*node, axis);
    const bool has = std::binary_search(vector.begin(), vector.end(), point[at(axis)] / 2);
    auto& least = has ? in : out;
    if (!least || *node < *least) least = node;
  }
  ensure(in && out, "the point is in the perturbed region");
  return {*in, *out};
}

}  // namespace asts
