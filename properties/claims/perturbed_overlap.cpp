#include "properties/claims/perturbed_overlap.hpp"

#include "properties/describe.hpp"
#include "properties/splines_needed.hpp"

namespace asts {

namespace {

Verdict overlapping_all_the_same(MeshUnderTest& mesh, const TellingSlice& slice) {
  const std::string axis = axis_name(slice.axis);
  return Verdict::violated(ClaimWitness{"perturbed-yet-overlapping",
                                        "the slice meets both supports, v1 has its projection on it in the skeleton "
                                        "and v2 has not, but their index vectors along the axis overlap",
                                        {{"axis", axis},
                                         {"slice", mesh.mesh().coordinate(slice.axis, slice.rank)},
                                         {"v1", describe_node(mesh.mesh(), mesh.splines(), slice.in)},
                                         {"v2", describe_node(mesh.mesh(), mesh.splines(), slice.out)}}});
}

}  // namespace

Trial judge_perturbed_means_no_overlap(MeshUnderTest& mesh, const SliceNodes& slice_nodes) {
  const TSplines& splines = mesh.splines();
  Trial trial;
  for (std::int32_t v = 0; v < splines.size(); ++v) {
    for (std::int32_t w = 0; w < v; ++w) {
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const std::vector<TellingSlice> slices = telling_slices(splines, slice_nodes, axis, v, w);
        if (slices.empty()) continue;
        trial.met += static_cast<std::int64_t>(slices.size());
        if (trial.verdict.outcome == Outcome::violated) continue;
        if (!overlap(splines.index_vector(v, axis), splines.index_vector(w, axis))) continue;
        trial.verdict = overlapping_all_the_same(mesh, slices.front());
      }
    }
  }
  return trial;
}

Trial perturbed_means_no_overlap(MeshUnderTest& mesh) {
  if (auto verdict = lacks_splines(mesh)) return {*verdict};
  return judge_perturbed_means_no_overlap(mesh, SliceNodes(mesh));
}

}  // namespace asts
