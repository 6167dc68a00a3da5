#include "lib/spline/perturbed_regions.hpp"

#include <algorithm>
#include <tuple>

#include "lib/exact/errors.hpp"
#include "lib/spline/axis_overlap.hpp"

namespace asts {

namespace {

std::size_t at(std::int32_t id) { return static_cast<std::size_t>(id); }

bool less_box(const Box& one, const Box& other) {
  return std::tie(one.lower, one.upper) < std::tie(other.lower, other.upper);
}

class RegionBuilder {
 public:
  RegionBuilder(const TSplines& splines, const Bricks& bricks, Axis axis)
      : splines_(splines), bricks_(bricks), axis_(axis), overlap_(bricks, axis) {}

  void add_pair(std::int32_t i, std::int32_t j) {
    if (overlap_.holds(bricks_.bricks[at(i)], bricks_.bricks[at(j)])) return;
    add_slices(i, j);
    add_slices(j, i);
  }

  std::vector<Perturbation> take() {
    drop_repeated();
    return std::move(result_);
  }

 private:
  void add_slices(std::int32_t in, std::int32_t out) {
    const Brick& has = bricks_.bricks[at(in)];
    const Brick& lacks = bricks_.bricks[at(out)];
    slices_.clear();
    append_missing(bricks_.profile(has, axis_).entries, bricks_.profile(lacks, axis_).entries, slices_);
    Perturbation piece{{}, in, out};
    for (Axis other = 0; other < kDimension; ++other) {
      if (other == axis_) continue;
      HalfRank& lower = piece.box.lower[at(other)];
      HalfRank& upper = piece.box.upper[at(other)];
      lower = 2 * std::max(has.support.lower[at(other)], lacks.support.lower[at(other)]);
      upper = 2 * std::min(has.support.upper[at(other)], lacks.support.upper[at(other)]);
      lower = std::max(lower, splines_.region.lower[at(other)]);
      upper = std::min(upper, splines_.region.upper[at(other)]);
      if (lower > upper) return;
    }
    for (const std::int32_t slice : slices_) {
      if (!splines_.region.contains(axis_, 2 * slice)) continue;
      piece.box.lower[at(axis_)] = piece.box.upper[at(axis_)] = 2 * slice;
      result_.push_back(piece);
    }
    if (result_.size() > 2 * distinct_ + 65536) drop_repeated();
  }

  void drop_repeated() {
    std::sort(result_.begin(), result_.end(), [](const Perturbation& one, const Perturbation& other) {
      if (!(one.box == other.box)) return less_box(one.box, other.box);
      return std::tie(one.in, one.out) < std::tie(other.in, other.out);
    });
    const auto same = [](const Perturbation& one, const Perturbation& other) { return one.box == other.box; };
    result_.erase(std::unique(result_.begin(), result_.end(), same), result_.end());
    distinct_ = result_.size();
  }

  const TSplines& splines_;
  const Bricks& bricks_;
  Axis axis_;
  AxisOverlap overlap_;
  std::vector<Perturbation> result_;
  std::size_t distinct_ = 0;
  std::vector<std::int32_t> slices_;
};

std::vector<Box> boxes_of(const std::vector<Perturbation>& pieces) {
  std::vector<Box> boxes;
  boxes.reserve(pieces.size());
  for (const Perturbation& piece : pieces) boxes.push_back(piece.box);
  return boxes;
}

/// The first index of a brick whose support contains a position along an axis.
std::int32_t index_covering(const TSplines& splines, const AxisProfile& profile, Axis axis, HalfRank position) {
  const IndexVectors& vectors = splines.vectors[at(axis)];
  for (std::size_t i = 0; i < profile.vector_ids.size(); ++i) {
    const std::int32_t id = profile.vector_ids[i];
    if (2 * vectors.front(id) <= position && position <= 2 * vectors.back(id)) return static_cast<std::int32_t>(i);
  }
  throw InternalError("no support of the brick covers the position");
}

}  // namespace

std::vector<Perturbation> perturbed_region(const TSplines& splines, const Bricks& bricks, Axis axis) {
  RegionBuilder builder(splines, bricks, axis);
  for (const auto& [i, j] : bricks.pairs) builder.add_pair(i, j);
  return builder.take();
}

std::optional<RegionsMeet> find_common_point(const std::vector<Perturbation>& first, Axis first_axis,
                                             const std::vector<Perturbation>& second, Axis second_axis) {
  std::optional<RegionsMeet> least;
  std::pair<std::int32_t, std::int32_t> least_pieces;
  for_each_meeting_pair(boxes_of(first), boxes_of(second), [&](std::int32_t i, std::int32_t j) {
    PerAxis<HalfRank> point;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      point[axis] = std::max(first[at(i)].box.lower[axis], second[at(j)].box.lower[axis]);
    }
    const std::pair pieces{i, j};
    if (least && std::tie(least->point, least_pieces) <= std::tie(point, pieces)) return;
    least = RegionsMeet{first_axis, second_axis, point, first[at(i)], second[at(j)]};
    least_pieces = pieces;
  });
  return least;
}

std::optional<RegionsMeet> find_meeting_regions(const TSplines& splines, const Bricks& bricks) {
  PerAxis<std::vector<Perturbation>> regions;
  for (Axis axis = 0; axis < kDimension; ++axis) regions[at(axis)] = perturbed_region(splines, bricks, axis);
  for (Axis first = 0; first < kDimension; ++first) {
    for (Axis second = first + 1; second < kDimension; ++second) {
      if (auto meeting = find_common_point(regions[at(first)], first, regions[at(second)], second)) return meeting;
    }
  }
  return std::nullopt;
}

std::pair<std::int32_t, std::int32_t> nodes_behind(const TSplines& splines, const Bricks& bricks,
                                                   const Perturbation& piece, Axis axis,
                                                   const PerAxis<HalfRank>& point) {
  const Brick& in = bricks.bricks[at(piece.in)];
  const Brick& out = bricks.bricks[at(piece.out)];
  PerAxis<std::int32_t> v;
  PerAxis<std::int32_t> w;
  for (Axis other = 0; other < kDimension; ++other) {
    const AxisProfile& has = bricks.profile(in, other);
    v[at(other)] = other == axis ? index_with_entry(splines, has, axis, point[at(axis)] / 2)
                                 : index_covering(splines, has, other, point[at(other)]);
    w[at(other)] = index_covering(splines, bricks.profile(out, other), other, point[at(other)]);
  }
  return {bricks.node(in, v), bricks.node(out, w)};
}

}  // namespace asts
