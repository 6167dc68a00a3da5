#include "properties/claims/slice_nodes.hpp"

#include <algorithm>

#include "lib/spline/index_sets.hpp"

namespace asts {

namespace {

/// The part of both supports that lies in the active region, along an axis, as half ranks; lower > upper: none.
RankInterval common_active_range(const TSplines& splines, Axis axis, std::int32_t v, std::int32_t w) {
  const RankInterval one = splines.support(v, axis);
  const RankInterval other = splines.support(w, axis);
  return {std::max({2 * one.lower, 2 * other.lower, splines.region.lower[at(axis)]}),
          std::min({2 * one.upper, 2 * other.upper, splines.region.upper[at(axis)]})};
}

}  // namespace

SliceNodes::SliceNodes(MeshUnderTest& mesh) : nodes_(at(mesh.splines().size())) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    members_[at(axis)].assign(mesh.mesh().coordinates[at(axis)].size() * nodes_, false);
    for (std::int32_t node = 0; node < mesh.splines().size(); ++node) {
      PerAxis<HalfRank> position = mesh.splines().nodes[at(node)];
      for (HalfRank& coordinate : position) coordinate *= 2;
      for (const std::int32_t rank : global_index_set(mesh.mesh(), axis, position)) set(axis, rank, node, true);
    }
  }
}

std::vector<TellingSlice> telling_slices(const TSplines& splines, const SliceNodes& slice_nodes, Axis axis,
                                         std::int32_t v, std::int32_t w) {
  for (Axis other = 0; other < kDimension; ++other) {
    const RankInterval range = common_active_range(splines, other, v, w);
    if (range.lower > range.upper) return {};
  }
  std::vector<TellingSlice> slices;
  const RankInterval range = common_active_range(splines, axis, v, w);
  for (std::int32_t rank = (range.lower + 1) / 2; 2 * rank <= range.upper; ++rank) {
    const bool has_v = slice_nodes.contains(axis, rank, v);
    if (has_v == slice_nodes.contains(axis, rank, w)) continue;
    slices.push_back({axis, rank, has_v ? v : w, has_v ? w : v});
  }
  return slices;
}

}  // namespace asts
