#include "reports/slices/slice_geometry.hpp"

#include <algorithm>
#include <tuple>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

using Side = ElementTrace::Side;

/// An element's trace by ranks, which are quick to sort and compare.
struct RankTrace {
  std::int32_t level;  ///< Mesh::kNoLevel is less than every level
  std::array<std::int32_t, 2> lower;
  std::array<std::int32_t, 2> upper;
  Side side;

  auto key() const { return std::tie(level, lower, upper); }
};

class Cut {
 public:
  Cut(MeshUnderTest& mesh, const Slice& slice)
      : test_(mesh),
        mesh_(mesh.mesh()),
        slice_(slice),
        a_(at(slice.axis)),
        axes_(axes_in(slice)),
        position_(half_rank(mesh_, slice.axis, slice.position)) {}

  SliceGeometry geometry() {
    SliceGeometry result;
    result.slice = slice_;
    result.domain = rectangle([](Axis) { return Rational(0); },
                              [&](Axis axis) { return Rational(mesh_.setting.domain[at(axis)]); });
    const ActiveRegion region = active_region(mesh_);
    if (!region.empty) {
      result.active_region = rectangle([&](Axis axis) { return margin(axis); }, [&](Axis axis) { return far(axis); });
      result.in_active_region = region.contains(slice_.axis, position_);
    }
    result.highest_level = test_.max_level().value_or(0);
    result.elements = elements();
    result.active_nodes = active_nodes();
    if (!test_.splines().missing) result.regions = regions();
    return result;
  }

 private:
  /// The active region's sides.
  Rational margin(Axis axis) const { return (mesh_.setting.degree[at(axis)] + 1) / 2; }
  Rational far(Axis axis) const { return mesh_.setting.domain[at(axis)] - margin(axis); }

  template <class Lower, class Upper>
  PlaneRectangle rectangle(const Lower& lower, const Upper& upper) const {
    return {{lower(axes_[0]), lower(axes_[1])}, {upper(axes_[0]), upper(axes_[1])}};
  }

  std::optional<Side> side_of(const Box& box) const {
    const HalfRank lower = 2 * box.lower[a_];
    const HalfRank upper = 2 * box.upper[a_];
    if (lower < position_ && position_ < upper) return Side::through;
    if (lower == position_) return Side::upper;
    if (upper == position_) return Side::lower;
    return std::nullopt;
  }

  std::vector<ElementTrace> elements() const {
    std::vector<RankTrace> traces;
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i) {
      const Box& box = mesh_.elements[i];
      const auto side = side_of(box);
      if (!side) continue;
      RankTrace trace{mesh_.levels[i], {}, {}, *side};
      for (std::size_t k = 0; k < 2; ++k) {
        trace.lower[k] = box.lower[at(axes_[k])];
        trace.upper[k] = box.upper[at(axes_[k])];
      }
      traces.push_back(trace);
    }
    return exact(merged(std::move(traces)));
  }

  /// Two elements with one trace and one level become one trace.
  static std::vector<RankTrace> merged(std::vector<RankTrace> traces) {
    std::sort(traces.begin(), traces.end(), [](const RankTrace& one, const RankTrace& other) {
      return std::tuple(one.key(), one.side) < std::tuple(other.key(), other.side);
    });
    std::vector<RankTrace> result;
    for (const RankTrace& trace : traces) {
      if (!result.empty() && result.back().key() == trace.key()) {
        result.back().side = Side::both;
      } else {
        result.push_back(trace);
      }
    }
    return result;
  }

  std::vector<ElementTrace> exact(const std::vector<RankTrace>& traces) const {
    std::vector<ElementTrace> result;
    for (const RankTrace& trace : traces) {
      const auto point = [&](const std::array<std::int32_t, 2>& ranks) {
        return PlanePoint{mesh_.coordinate(axes_[0], ranks[0]), mesh_.coordinate(axes_[1], ranks[1])};
      };
      const auto level = trace.level == Mesh::kNoLevel ? std::nullopt : std::optional(trace.level);
      result.push_back({{point(trace.lower), point(trace.upper)}, level, trace.side});
    }
    return result;
  }

  std::vector<PlanePoint> active_nodes() const {
    std::vector<PlanePoint> result;
    for (const PerAxis<std::int32_t>& node : test_.splines().nodes) {
      if (2 * node[a_] != position_) continue;
      result.push_back(
          {mesh_.coordinate(axes_[0], node[at(axes_[0])]), mesh_.coordinate(axes_[1], node[at(axes_[1])])});
    }
    return result;
  }

  /// A position between lines is the open interval there: of a closed region without its sides, or, beside the active
  /// region's sides, the part up to these.
  Rational lower_end(Axis axis, HalfRank end) const { return std::max(mesh_.coordinate(axis, end / 2), margin(axis)); }
  Rational upper_end(Axis axis, HalfRank end) const {
    return std::min(mesh_.coordinate(axis, (end + 1) / 2), far(axis));
  }

  PerAxis<std::vector<PlaneRectangle>> regions() {
    PerAxis<std::vector<PlaneRectangle>> result;
    for (std::size_t region = 0; region < kDimension; ++region) {
      for (const Box& box : test_.perturbed_regions()[region]) {
        if (box.lower[a_] > position_ || position_ > box.upper[a_]) continue;
        result[region].push_back(rectangle([&](Axis axis) { return lower_end(axis, box.lower[at(axis)]); },
                                           [&](Axis axis) { return upper_end(axis, box.upper[at(axis)]); }));
      }
    }
    return result;
  }

  MeshUnderTest& test_;
  const Mesh& mesh_;
  Slice slice_;
  std::size_t a_;
  std::array<Axis, 2> axes_;
  HalfRank position_;
};

}  // namespace

std::array<Axis, 2> axes_in(const Slice& slice) { return {slice.axis == 0 ? 1 : 0, slice.axis == 2 ? 1 : 2}; }

SliceGeometry cut(MeshUnderTest& mesh, const Slice& slice) {
  require(slice.position >= 0 && slice.position <= mesh.mesh().setting.domain[at(slice.axis)],
          "the slice is outside the domain");
  return Cut(mesh, slice).geometry();
}

}  // namespace asts
