#include "properties/describe.hpp"
#include "properties/properties.hpp"
#include "properties/sequence_under_test.hpp"
#include "properties/splines_needed.hpp"

namespace asts {

Verdict decide_analysis_suitable(MeshUnderTest& mesh) {
  if (auto verdict = lacks_splines(mesh)) return *verdict;
  const auto& meeting = mesh.meeting_regions();
  return meeting ? Verdict::violated(describe_meeting(mesh, *meeting)) : Verdict::holds();
}

std::optional<Verdict> analysis_suitable_in_sequence(SequenceUnderTest& sequence) {
  return sequence.decide_proven(&Proven::analysis_suitable);
}

}  // namespace asts
