#include "properties/claims/distance_bound.hpp"

#include <map>

#include "lib/mesh/level_formulas.hpp"
#include "lib/refine/complexity_constants.hpp"
#include "properties/claims/family_equations.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

/// The largest distance along one axis of a new element of one level to the mark that made it.
struct Farthest {
  Rational distance = -1;
  std::size_t mark = 0;
  std::size_t parent = 0;
};

using ByLevel = std::map<std::int32_t, PerAxis<Farthest>>;

/// How far the outer children's midpoints are from the parent's along an axis.
Rational child_offset(const Setting& setting, int parent_level, Axis axis) {
  if (axis != parent_level % kDimension) return 0;
  return level_size(setting.grading, parent_level)[at(axis)] * (setting.grading - 1) / (2 * setting.grading);
}

ByLevel farthest_new_elements(const RefinementTree& tree, const LeafPatches& patches, std::int64_t& met) {
  ByLevel result;
  for (std::size_t mark = 0; mark < patches.size(); ++mark) {
    for (const std::size_t parent : patches.closure(mark)) {
      met += parent != mark;
      const int level = patches.level(parent);
      PerAxis<Farthest>& farthest = result[level + 1];
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const Rational distance = abs(Rational(patches.midpoint(mark)[at(axis)] - patches.midpoint(parent)[at(axis)])) +
                                  child_offset(tree.setting(), level, axis);
        if (distance > farthest[at(axis)].distance) farthest[at(axis)] = {distance, mark, parent};
      }
    }
  }
  return result;
}

ClaimWitness witness_of(const RefinementTree& tree, const LeafPatches& patches, const Farthest& farthest, Axis axis,
                        const CubeRootNumber& bound) {
  ClaimWitness witness{"too-far",
                       "a child K of K_0, which the mark K' makes the algorithm subdivide, is farther from K' "
                       "than the bound",
                       {}};
  witness.values = {{"K'", describe_tree_element(tree, patches.node(farthest.mark))},
                    {"K_0", describe_tree_element(tree, patches.node(farthest.parent))},
                    {"axis", std::string(axis_name(axis))},
                    {"largest distance along the axis of a child of K_0 from K'", farthest.distance},
                    {"bound along the axis", shown(bound)}};
  return witness;
}

using Constants = PerAxis<CubeRootNumber> (*)(const PerAxis<int>& degree, int grading);

Trial distance_bound_with(MeshUnderTest& mesh, std::initializer_list<Constants> all_constants) {
  if (!mesh.admissible()) return {Verdict::not_applicable("the mesh is not admissible")};
  const Setting& setting = mesh.tree().setting();
  const LeafPatches patches(mesh);
  Trial trial;
  for (const Constants constants : all_constants) {
    trial.met = 0;
    auto witness = judge_distance_bound(mesh.tree(), patches, constants(setting.degree, setting.grading), trial.met);
    if (witness) return {Verdict::violated(std::move(*witness)), trial.met};
  }
  return trial;
}

}  // namespace

/// level(K) <= level(K') + 1 needs no look: every element of the closure of K' is K' or coarser than it.
std::optional<ClaimWitness> judge_distance_bound(const RefinementTree& tree, const LeafPatches& patches,
                                                 const PerAxis<CubeRootNumber>& d, std::int64_t& met) {
  for (const auto& [level, farthest] : farthest_new_elements(tree, patches, met)) {
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const CubeRootNumber bound = cube_root_power(tree.setting().grading, -level) * d[at(axis)];
      if (bound < farthest[at(axis)].distance) return witness_of(tree, patches, farthest[at(axis)], axis, bound);
    }
  }
  return std::nullopt;
}

Trial distance_bound_on_mesh(MeshUnderTest& mesh) { return distance_bound_with(mesh, {distance_constants}); }

Trial distance_bound_repaired_on_mesh(MeshUnderTest& mesh) {
  if (mesh.tree().setting().grading > kLargestGradingOfPrintedConstants) {
    return distance_bound_with(mesh, {corrected_distance_constants});
  }
  return distance_bound_with(mesh, {corrected_distance_constants, distance_constants});
}

}  // namespace asts
