#include "properties/describe.hpp"
#include "properties/properties.hpp"
#include "properties/splines_needed.hpp"

namespace asts {

Verdict decide_analysis_suitable(MeshUnderTest& mesh) {
  if (auto verdict = lacks_splines(mesh)) return *verdict;
  const auto& meeting = mesh.meeting_regions();
  return meeting ? Verdict::violated(describe_meeting(mesh, *meeting)) : Verdict::holds();
}

}  // namespace asts
