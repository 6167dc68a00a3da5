#include "lib/spline/dual_basis.hpp"

#include "properties/describe.hpp"
#include "properties/properties.hpp"
#include "properties/sequence_under_test.hpp"
#include "properties/splines_needed.hpp"

namespace asts {

Verdict decide_dual_basis(MeshUnderTest& mesh) {
  if (auto verdict = lacks_splines(mesh)) return *verdict;
  const DualBasisFailures& failures = mesh.dual_failures();
  if (!failures.one) return Verdict::holds();
  const auto [v, w] = *failures.one;
  DualValue value = dual_value(mesh.mesh(), mesh.splines(), v, w);
  return Verdict::violated(LambdaNotDeltaWitness{
      describe_node(mesh.mesh(), mesh.splines(), v), describe_node(mesh.mesh(), mesh.splines(), w),
      std::move(value.factors), std::move(value.value), v == w ? 1 : 0, failures.failures, failures.pairs});
}

std::optional<Verdict> dual_basis_in_sequence(SequenceUnderTest& sequence) {
  return sequence.decide_proven(&Proven::dual_basis);
}

}  // namespace asts
