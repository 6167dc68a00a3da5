#include "lib/spline/perturbed_regions.hpp"
#include "properties/describe.hpp"
#include "properties/properties.hpp"
#include "properties/splines_needed.hpp"

namespace asts {

namespace {

PerturbationInfo describe_perturbation(MeshUnderTest& mesh, const PerAxis<HalfRank>& point, Axis axis) {
  const auto [in, out] = nodes_behind(mesh.splines(), mesh.bricks(), axis, point);
  return {axis, coordinate_of(mesh.mesh(), axis, point[at(axis)]), describe_node(mesh.mesh(), mesh.splines(), in),
          describe_node(mesh.mesh(), mesh.splines(), out)};
}

}  // namespace

Verdict decide_analysis_suitable(MeshUnderTest& mesh) {
  if (auto verdict = lacks_splines(mesh)) return *verdict;
  const auto meeting = find_meeting_regions(mesh.splines(), mesh.bricks());
  if (!meeting) return Verdict::holds();
  ExactPoint point;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto a = at(axis);
    point[a] = coordinate_of(mesh.mesh(), axis, meeting->point[a]);
  }
  return Verdict::violated(RegionsMeetWitness{point, describe_perturbation(mesh, meeting->point, meeting->first_axis),
                                              describe_perturbation(mesh, meeting->point, meeting->second_axis)});
}

}  // namespace asts
