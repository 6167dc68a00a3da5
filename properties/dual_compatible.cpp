#include "lib/spline/dual_compatibility.hpp"
#include "properties/describe.hpp"
#include "properties/properties.hpp"
#include "properties/sequence_under_test.hpp"
#include "properties/splines_needed.hpp"

namespace asts {

namespace {

/// One coordinate an axis that keeps two index vectors from overlapping, where they do not.
std::vector<NoOverlapInfo> missing_overlaps(const Mesh& mesh, const TSplines& splines, const NodePair& pair) {
  std::vector<NoOverlapInfo> result;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    std::vector<std::int32_t> missing;
    append_missing(splines.index_vector(pair.v, axis), splines.index_vector(pair.w, axis), missing);
    const bool in_v = !missing.empty();
    if (!in_v) append_missing(splines.index_vector(pair.w, axis), splines.index_vector(pair.v, axis), missing);
    if (!missing.empty()) result.push_back({axis, mesh.coordinate(axis, missing.front()), in_v});
  }
  return result;
}

}  // namespace

Verdict decide_dual_compatible(MeshUnderTest& mesh) {
  if (auto verdict = lacks_splines(mesh)) return *verdict;
  const auto& pair = mesh.incompatible();
  if (!pair) return Verdict::holds();
  return Verdict::violated(NoPartialOverlapWitness{describe_node(mesh.mesh(), mesh.splines(), pair->v),
                                                   describe_node(mesh.mesh(), mesh.splines(), pair->w),
                                                   missing_overlaps(mesh.mesh(), mesh.splines(), *pair)});
}

std::optional<Verdict> dual_compatible_in_sequence(SequenceUnderTest& sequence) {
  return sequence.decide_proven(&Proven::dual_compatible);
}

}  // namespace asts
