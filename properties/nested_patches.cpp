#include <algorithm>

#include "lib/exact/errors.hpp"
#include "properties/describe.hpp"
#include "properties/properties.hpp"
#include "properties/sequence_under_test.hpp"

namespace asts {

namespace {

/// Whether U(inner) lies in U(outer): both are open boxes, not empty.
bool environment_within(const RefinementTree& tree, std::int32_t inner, std::int32_t outer) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval small = tree.environment(inner, axis);
    const RankInterval large = tree.environment(outer, axis);
    if (small.lower < large.lower || small.upper > large.upper) return false;
  }
  return true;
}

/// An element of the mesh that meets U(inner) and not U(outer), found by asking all elements: this happens only on the
/// way to a witness.
std::optional<std::int32_t> element_outside(const Mesh& mesh, const RefinementTree& tree, std::int32_t inner,
                                            std::int32_t outer) {
  const ExactBox small = describe_environment(tree, inner);
  const ExactBox large = describe_environment(tree, outer);
  const auto meets = [](const ExactBox& element, const ExactBox& open) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if (element.upper[axis] <= open.lower[axis] || element.lower[axis] >= open.upper[axis]) return false;
    }
    return true;
  };
  for (std::int32_t element = 0; element < static_cast<std::int32_t>(mesh.elements.size()); ++element) {
    const ExactBox box = describe_element(mesh, element).box;
    if (meets(box, small) && !meets(box, large)) return element;
  }
  return std::nullopt;
}

}  // namespace

/// If U(K) lies in U(L), so does the patch of K in that of L, on any mesh. Inclusion is transitive, so that pairs of
/// parent and child are enough as long as all of these are nested; the first pair that is not is looked at in full,
/// and only when its patches agree by chance are all pairs above it asked.
Verdict decide_nested_patches(MeshUnderTest& mesh) {
  const RefinementTree& tree = mesh.tree();
  const std::vector<std::int32_t> elements = mesh.tree_elements();
  if (elements.empty()) return Verdict::not_applicable("no element belongs to a refinement of the initial mesh");
  for (const std::int32_t inner : elements) {
    for (std::int32_t outer = tree.node(inner).parent; outer != RefinementTree::kNone && tree.node(outer).level >= 0;
         outer = tree.node(outer).parent) {
      if (environment_within(tree, inner, outer)) break;
      if (const auto element = element_outside(mesh.mesh(), tree, inner, outer)) {
        return Verdict::violated(PatchNotNestedWitness{describe_tree_element(tree, inner),
                                                       describe_tree_element(tree, outer),
                                                       describe_element(mesh.mesh(), *element)});
      }
    }
  }
  return Verdict::holds();
}

/// The environments of an element and its child have the same extent along two axes.
std::optional<Verdict> nested_patches_in_sequence(SequenceUnderTest& sequence) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    if (!sequence.tree().grid(axis).windows_nested()) return std::nullopt;
  }
  return Verdict::holds();
}

}  // namespace asts
