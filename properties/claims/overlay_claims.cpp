#include "properties/claims/overlay_claims.hpp"

#include <algorithm>

#include "lib/mesh/reflection.hpp"
#include "lib/refine/admissibility.hpp"
#include "lib/refine/overlay.hpp"
#include "lib/refine/refinement.hpp"
#include "properties/claims/on_class.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

/// Refined in the corner (X~, Y~, Z~), one mark a step.
RefinementTree refined_in_far_corner(const Setting& setting, std::int32_t level, std::int64_t elements) {
  Point corner;
  for (std::size_t axis = 0; axis < kDimension; ++axis) corner[axis] = CompactRational(setting.domain[axis]);
  RefinementTree tree(setting);
  while (tree.max_level() < level && tree.element_count() < elements) refine(tree, Elements{tree.leaf_at(corner)});
  return tree;
}

/// Neither mesh refines the other: the overlay, when it is the coarsest, is a third mesh.
bool incomparable(const RefinementTree& one, const RefinementTree& other) {
  const std::int64_t elements = overlay(one, other).element_count();
  return elements > one.element_count() && elements > other.element_count();
}

/// One of the meshes that a witness is about: what its tree has subdivided.
void append_subdivided(const char* name, const RefinementTree& tree, ClaimWitness& witness) {
  Elements subdivided;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.node(id).level >= 0 && !tree.is_leaf(id)) subdivided.push_back(id);
  }
  append_elements(witness, name, tree, subdivided);
}

template <class Judge>
Trial with_all_partners(MeshUnderTest& mesh, Judge judge) {
  if (auto reason = not_admissible(mesh)) return {*reason};
  Trial trial;
  for (const RefinementTree& partner : overlay_partners(mesh.tree())) {
    const Trial one = judge(mesh.tree(), partner, overlay);
    trial.met += one.met;
    if (one.verdict.outcome != Outcome::holds) return {one.verdict, trial.met};
  }
  return trial;
}

}  // namespace

Trial judge_overlay_admissible(const RefinementTree& one, const RefinementTree& other,
                               const CommonRefinement& combine) {
  Trial trial{Verdict::holds(), incomparable(one, other)};
  const RefinementTree both = combine(one, other);
  const auto found = find_inadmissible(both);
  if (!found) return trial;
  ClaimWitness witness{"overlay-not-admissible",
                       "a subdivided element of the overlay has a coarser one in its patch",
                       {{"element", describe_tree_element(both, found->element)},
                        {"environment", describe_environment(both, found->element)},
                        {"coarser", describe_tree_element(both, found->coarser)}}};
  append_subdivided("subdivided in G1", one, witness);
  append_subdivided("subdivided in G2", other, witness);
  trial.verdict = Verdict::violated(std::move(witness));
  return trial;
}

Trial judge_overlay_cardinality(const RefinementTree& one, const RefinementTree& other,
                                const CommonRefinement& combine) {
  Trial trial{Verdict::holds(), incomparable(one, other)};
  const std::int64_t initial = RefinementTree(one.setting()).element_count();
  const std::int64_t both = combine(one, other).element_count();
  if (both + initial <= one.element_count() + other.element_count()) return trial;
  ClaimWitness witness{"overlay-too-large",
                       "elements(G1 (+) G2) + elements(G0) > elements(G1) + elements(G2)",
                       {{"elements of G1 (+) G2", both},
                        {"elements of G0", initial},
                        {"elements of G1", one.element_count()},
                        {"elements of G2", other.element_count()}}};
  append_subdivided("subdivided in G1", one, witness);
  append_subdivided("subdivided in G2", other, witness);
  trial.verdict = Verdict::violated(std::move(witness));
  return trial;
}

Trial overlay_trial(const RefinementTree& one, const RefinementTree& other) {
  Trial trial = judge_overlay_admissible(one, other, overlay);
  if (trial.verdict.outcome == Outcome::holds) trial = judge_overlay_cardinality(one, other, overlay);
  return trial;
}

std::vector<RefinementTree> overlay_partners(const RefinementTree& tree) {
  std::vector<RefinementTree> partners;
  for (const PerAxis<bool>& axes : reflections()) partners.push_back(reflect(tree, axes).tree);
  partners.push_back(refined_in_far_corner(tree.setting(), tree.max_level(), tree.element_count()));
  return partners;
}

Trial try_overlay_admissible(MeshUnderTest& mesh) { return with_all_partners(mesh, judge_overlay_admissible); }

Trial try_overlay_cardinality(MeshUnderTest& mesh) { return with_all_partners(mesh, judge_overlay_cardinality); }

}  // namespace asts
