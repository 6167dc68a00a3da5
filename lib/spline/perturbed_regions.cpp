#include "lib/spline/perturbed_regions.hpp"

#include <algorithm>
#include <tuple>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

std::size_t at(std::int32_t id) { return static_cast<std::size_t>(id); }

bool less_box(const Box& one, const Box& other) {
  return std::tie(one.lower, one.upper) < std::tie(other.lower, other.upper);
}

class RegionBuilder {
 public:
  RegionBuilder(const TSplines& splines, const LineRuns& runs, Axis axis)
      : splines_(splines), runs_(runs), axis_(axis) {}

  void add_pair(std::int32_t i, std::int32_t j) {
    const std::int32_t a = vector_of(i);
    const std::int32_t b = vector_of(j);
    const IndexVectors& vectors = splines_.vectors[at(axis_)];
    if (a == b || overlap(vectors[a], vectors[b])) return;
    add_slices(i, j, vectors[a], vectors[b]);
    add_slices(j, i, vectors[b], vectors[a]);
  }

  std::vector<Perturbation> take() {
    drop_repeated();
    return std::move(result_);
  }

 private:
  std::int32_t vector_of(std::int32_t run) const {
    const std::int32_t node = splines_.line_order[at(runs_.axis)][at(runs_.runs[at(run)].begin)];
    return splines_.vector_ids[at(node)][at(axis_)];
  }

  void add_slices(std::int32_t in, std::int32_t out, std::span<const std::int32_t> has,
                  std::span<const std::int32_t> lacks) {
    slices_.clear();
    append_missing(has, lacks, slices_);
    if (slices_.empty()) return;
    Perturbation piece{{}, in, out};
    for (Axis other = 0; other < kDimension; ++other) {
      if (other == axis_) continue;
      const Box& one = runs_.runs[at(in)].support;
      const Box& two = runs_.runs[at(out)].support;
      HalfRank& lower = piece.box.lower[at(other)];
      HalfRank& upper = piece.box.upper[at(other)];
      lower = std::max(2 * std::max(one.lower[at(other)], two.lower[at(other)]), splines_.region.lower[at(other)]);
      upper = std::min(2 * std::min(one.upper[at(other)], two.upper[at(other)]), splines_.region.upper[at(other)]);
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
  const LineRuns& runs_;
  Axis axis_;
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

}  // namespace

std::vector<Perturbation> perturbed_region(const TSplines& splines, const LineRuns& runs, Axis axis) {
  require(runs.axis != axis, "runs along the axis of the region do not share its index vectors");
  RegionBuilder builder(splines, runs, axis);
  for (const auto& [i, j] : runs.pairs) builder.add_pair(i, j);
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

std::optional<RegionsMeet> find_meeting_regions(const TSplines& splines, const LineRuns& along_x,
                                                const LineRuns& along_y) {
  PerAxis<std::vector<Perturbation>> regions;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    regions[at(axis)] = perturbed_region(splines, axis == along_x.axis ? along_y : along_x, axis);
  }
  for (Axis first = 0; first < kDimension; ++first) {
    for (Axis second = first + 1; second < kDimension; ++second) {
      if (auto meeting = find_common_point(regions[at(first)], first, regions[at(second)], second)) return meeting;
    }
  }
  return std::nullopt;
}

std::int32_t node_covering(const TSplines& splines, const LineRuns& runs, std::int32_t run, HalfRank position) {
  const LineRun& members = runs.runs[at(run)];
  for (std::int32_t i = members.begin; i < members.end; ++i) {
    const std::int32_t node = splines.line_order[at(runs.axis)][at(i)];
    const RankInterval support = splines.support(node, runs.axis);
    if (2 * support.lower <= position && position <= 2 * support.upper) return node;
  }
  throw InternalError("no node of the run covers the position");
}

}  // namespace asts
