#include "properties/claims/patch_claims.hpp"

#include <optional>

#include "lib/exact/errors.hpp"
#include "lib/refine/refinement.hpp"
#include "properties/claims/on_class.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

/// Elements of a tree two generations below the mesh's leaves: beyond it the verdict is undecided.
constexpr std::int64_t kMostDescendants = 20'000'000;

/// The tree with two more generations below every leaf; the ids of the old nodes stay.
RefinementTree two_generations_deeper(const RefinementTree& tree) {
  const int grading = tree.setting().grading;
  if (tree.element_count() > kMostDescendants / grading / grading) {
    throw BudgetExhausted("the mesh has too many grandchildren to compare their patches");
  }
  RefinementTree deeper = tree;
  for (int generation = 0; generation < 2; ++generation) subdivide_all(deeper, leaves_in_order(deeper));
  return deeper;
}

using Extents = PerAxis<RankInterval>;

Extents extents_of(const RefinementTree& tree, std::int32_t k, const EnvironmentOf& environment) {
  Extents result;
  for (Axis axis = 0; axis < kDimension; ++axis) result[at(axis)] = environment(tree, k, axis);
  return result;
}

/// Whether one open box lies in the other; then so do the patches, on any mesh.
bool within(const Extents& inner, const Extents& outer) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (inner[axis].lower < outer[axis].lower || inner[axis].upper > outer[axis].upper) return false;
  }
  return true;
}

bool meets(const RefinementTree& tree, std::int32_t element, const Extents& open) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval closed = tree.extent(element, axis);
    if (closed.upper <= open[at(axis)].lower || closed.lower >= open[at(axis)].upper) return false;
  }
  return true;
}

/// An element of the mesh that belongs to the first patch and not to the second.
std::optional<std::int32_t> only_in_first(const RefinementTree& tree, const Elements& mesh, const Extents& first,
                                          const Extents& second) {
  for (const std::int32_t element : mesh) {
    if (meets(tree, element, first) && !meets(tree, element, second)) return element;
  }
  return std::nullopt;
}

}  // namespace

/// Inclusion of environments is transitive, so parents are enough as long as these include their children; where one
/// does not, the patches are compared with those of all elements above, element by element.
Trial judge_patches_nested(const RefinementTree& tree, const EnvironmentOf& environment) {
  const RefinementTree deeper = two_generations_deeper(tree);
  const Elements mesh = leaves_in_order(tree);
  Trial trial;
  for (std::int32_t k = 0; k < deeper.node_count(); ++k) {
    if (deeper.node(k).level <= 0) continue;
    trial.met += deeper.node(k).level;  // as many elements contain K
    const Extents inner = extents_of(deeper, k, environment);
    for (std::int32_t outer = deeper.node(k).parent; deeper.node(outer).level >= 0; outer = deeper.node(outer).parent) {
      const Extents around = extents_of(deeper, outer, environment);
      if (within(inner, around)) break;
      if (const auto element = only_in_first(deeper, mesh, inner, around)) {
        return {Verdict::violated(PatchNotNestedWitness{describe_tree_element(deeper, k),
                                                        describe_tree_element(deeper, outer),
                                                        describe_tree_element(deeper, *element)}),
                trial.met};
      }
      if (deeper.node(outer).parent == RefinementTree::kNone) break;  // a domain of one cube has no block above it
    }
  }
  return trial;
}

Trial judge_levels_change_slowly(const RefinementTree& tree, const InPatch& belongs) {
  const Elements mesh = leaves_in_order(tree);
  Trial trial;
  for (const std::int32_t k : mesh) {
    const std::int32_t level = tree.node(k).level;
    bool another_level = false;
    for (const std::int32_t element : mesh) {
      const std::int32_t other = tree.node(element).level;
      if (other == level || (other > level && another_level) || !belongs(tree, k, element)) continue;
      another_level = true;
      if (other < level - 1) {
        return {Verdict::violated(CoarserInPatchWitness{describe_tree_element(tree, k), describe_environment(tree, k),
                                                        describe_tree_element(tree, element)}),
                trial.met + 1};
      }
    }
    trial.met += another_level;
  }
  return trial;
}

Trial try_patches_nested(MeshUnderTest& mesh) {
  if (auto reason = outside_class(mesh)) return {*reason};
  return judge_patches_nested(
      mesh.tree(), [](const RefinementTree& tree, std::int32_t k, Axis axis) { return tree.environment(k, axis); });
}

Trial try_levels_change_slowly(MeshUnderTest& mesh) {
  if (auto reason = not_admissible(mesh)) return {*reason};
  return judge_levels_change_slowly(mesh.tree(), in_patch);
}

}  // namespace asts
