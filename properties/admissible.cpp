#include "lib/refine/admissibility.hpp"
#include "properties/describe.hpp"
#include "properties/properties.hpp"
#include "properties/sequence_under_test.hpp"

namespace asts {

Verdict decide_admissible(MeshUnderTest& mesh) {
  if (const auto outside = mesh.outside_class()) {
    return Verdict::violated(OutsideClassWitness{describe_element(mesh.mesh(), *outside)});
  }
  const RefinementTree& tree = mesh.tree();
  const auto found = find_inadmissible(tree);
  if (!found) return Verdict::holds();
  return Verdict::violated(CoarserInPatchWitness{describe_tree_element(tree, found->element),
                                                 describe_environment(tree, found->element),
                                                 describe_tree_element(tree, found->coarser)});
}

std::optional<Verdict> admissible_in_sequence(SequenceUnderTest& sequence) {
  if (!sequence.admissible()) return std::nullopt;
  return Verdict::holds();
}

}  // namespace asts
