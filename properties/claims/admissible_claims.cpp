#include "properties/claims/admissible_claims.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "lib/refine/admissibility.hpp"
#include "lib/refine/refinement.hpp"
#include "properties/claims/on_class.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

ClaimWitness with_marks(const char* kind, const char* says, const RefinementTree& tree, const Elements& marks) {
  ClaimWitness witness{kind, says, {}};
  append_elements(witness, "mark", tree, marks);
  return witness;
}

/// Both halves of the theorem for one set of marks.
std::optional<Verdict> not_admissible_after(const RefinementTree& tree, const Elements& marks,
                                            const Elements& closure) {
  RefinementTree refined = tree;
  subdivide_all(refined, closure);
  if (const auto found = find_inadmissible(refined)) {
    ClaimWitness witness =
        with_marks("refined-mesh-not-admissible", "a subdivided element has a coarser one in its patch", tree, marks);
    witness.values.emplace_back("element", describe_tree_element(refined, found->element));
    witness.values.emplace_back("environment", describe_environment(refined, found->element));
    witness.values.emplace_back("coarser", describe_tree_element(refined, found->coarser));
    return Verdict::violated(std::move(witness));
  }
  if (is_admissible_subdivision(tree, closure)) return std::nullopt;
  return Verdict::violated(with_marks("subdivision-not-admissible",
                                      "no order makes each subdivision of the closure admissible", tree, marks));
}

/// A mesh that grows from the initial one towards a target, and where the target's elements are in it.
class Growing {
 public:
  /// The nodes from the domain down to the unit cubes come first, and are the same in all trees of a setting.
  explicit Growing(const RefinementTree& target)
      : target_(target), tree_(target.setting()), place_(at(target.node_count()), RefinementTree::kNone) {
    for (std::int32_t id = 0; id < tree_.node_count(); ++id) place_[at(id)] = id;
    for (std::int32_t id = 0; id < target.node_count(); ++id) {
      if (target.node(id).level >= 0 && !target.is_leaf(id)) inner_.push_back(id);
    }
    std::sort(inner_.begin(), inner_.end(),
              [&](std::int32_t a, std::int32_t b) { return place_in_order(a) < place_in_order(b); });
  }

  RefinementTree& tree() { return tree_; }
  /// The elements to subdivide, by rising level, so that those above an element come before it, and by their lower
  /// corners.
  const Elements& inner() const { return inner_; }
  std::int32_t place(std::int32_t id) const { return place_[at(id)]; }

  /// After the element's subdivision: finds its children.
  void find_children(std::int32_t id) {
    for (std::int32_t j = 0; j < target_.child_count(id); ++j) {
      place_[at(target_.node(id).first_child + j)] = tree_.node(place(id)).first_child + j;
    }
  }

 private:
  std::array<std::int32_t, 4> place_in_order(std::int32_t id) const {
    return {target_.node(id).level, target_.extent(id, 0).lower, target_.extent(id, 1).lower,
            target_.extent(id, 2).lower};
  }

  const RefinementTree& target_;
  RefinementTree tree_;
  Elements place_;
  Elements inner_;
};

Verdict not_alone(const RefinementTree& target, std::int32_t id, std::int64_t before, std::int64_t after) {
  return Verdict::violated(
      ClaimWitness{"refine-subdivides-others",
                   "marked in the order of levels, and of lower corners among equal ones, the element is not "
                   "subdivided by its call of refine, or not alone",
                   {{"element", describe_tree_element(target, id)},
                    {"elements before", before},
                    {"elements after", after},
                    {"grading", std::int64_t{target.setting().grading}}}});
}

/// An element of the growing mesh that is coarser than K in its patch.
std::optional<std::int32_t> coarser_than(const RefinementTree& tree, std::int32_t k, const InPatch& belongs) {
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    const std::int32_t level = tree.node(id).level;
    if (level >= 0 && level < tree.node(k).level && tree.is_leaf(id) && belongs(tree, k, id)) return id;
  }
  return std::nullopt;
}

}  // namespace

Trial judge_refine_admissible(const RefinementTree& tree, const ClosureOf& closure_of) {
  Trial trial;
  for (const std::int32_t leaf : leaves_in_order(tree)) {
    const Elements closure = closure_of(tree, {leaf});
    trial.met += closure.size() > 1;
    if (auto verdict = not_admissible_after(tree, {leaf}, closure)) return {*verdict, trial.met};
  }
  for (const Elements& marks : mark_sets(tree)) {
    if (auto verdict = not_admissible_after(tree, marks, closure_of(tree, marks))) return {*verdict, trial.met};
  }
  return trial;
}

/// Each call subdivides the mark, and the mesh has m - 1 elements more, so it subdivides nothing else: the calls for
/// all inner elements of the target's tree make exactly the target.
Trial judge_refine_generates(const RefinementTree& target, const RefineOne& refine_one) {
  Growing growing(target);
  Trial trial;
  for (const std::int32_t id : growing.inner()) {
    const std::int32_t mark = growing.place(id);
    const std::int64_t before = growing.tree().element_count();
    if (growing.tree().is_leaf(mark)) refine_one(growing.tree(), mark);
    const std::int64_t after = growing.tree().element_count();
    if (growing.tree().is_leaf(mark) || after != before + target.setting().grading - 1) {
      return {not_alone(target, id, before, after), trial.met};
    }
    growing.find_children(id);
    trial.met += target.node(id).level > 0;
  }
  return trial;
}

Trial judge_level_order(const RefinementTree& target, const InPatch& belongs) {
  Growing growing(target);
  Trial trial;
  for (const std::int32_t id : growing.inner()) {
    const std::int32_t k = growing.place(id);
    RefinementTree& tree = growing.tree();
    trial.met += target.node(id).level > 0;
    if (const auto coarser = coarser_than(tree, k, belongs)) {
      return {Verdict::violated(CoarserInPatchWitness{describe_tree_element(tree, k), describe_environment(tree, k),
                                                      describe_tree_element(tree, *coarser)}),
              trial.met};
    }
    subdivide_all(tree, Elements{k});
    growing.find_children(id);
  }
  return trial;
}

Trial try_refine_admissible(MeshUnderTest& mesh) {
  if (auto reason = not_admissible(mesh)) return {*reason};
  return judge_refine_admissible(mesh.tree(), closure_of_marks);
}

Trial try_refine_generates(MeshUnderTest& mesh) {
  if (auto reason = not_admissible(mesh)) return {*reason};
  return judge_refine_generates(mesh.tree(),
                                [](RefinementTree& tree, std::int32_t mark) { refine(tree, Elements{mark}); });
}

Trial try_level_order(MeshUnderTest& mesh) {
  if (auto reason = not_admissible(mesh)) return {*reason};
  return judge_level_order(mesh.tree(), in_patch);
}

}  // namespace asts
