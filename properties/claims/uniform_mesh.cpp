#include "properties/claims/uniform_mesh.hpp"

#include <algorithm>

#include "lib/refine/refinement.hpp"
#include "lib/spline/perturbed_regions.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

/// The coordinates inside the active region that some active node has: there is a face there.
std::int64_t slices_with_nodes(const TSplines& splines) {
  std::int64_t count = 0;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    std::vector<std::int32_t> ranks;
    for (const PerAxis<std::int32_t>& node : splines.nodes) ranks.push_back(node[axis]);
    std::sort(ranks.begin(), ranks.end());
    count += std::unique(ranks.begin(), ranks.end()) - ranks.begin();
  }
  return count;
}

Verdict not_empty(MeshUnderTest& mesh, Axis axis, const Box& part) {
  ExactPoint point;
  for (Axis other = 0; other < kDimension; ++other) {
    point[at(other)] = coordinate_of(mesh.mesh(), other, part.lower[at(other)]);
  }
  const auto [in, out] = nodes_behind(mesh.splines(), mesh.bricks(), axis, part.lower);
  return Verdict::violated(ClaimWitness{"perturbed",
                                        "the point is in the perturbed region of the axis, though the mesh is uniform",
                                        {{"axis", std::string(axis_name(axis))},
                                         {"point", point},
                                         {"in", describe_node(mesh.mesh(), mesh.splines(), in)},
                                         {"out", describe_node(mesh.mesh(), mesh.splines(), out)}}});
}

}  // namespace

Trial judge_unperturbed(MeshUnderTest& mesh) {
  if (mesh.splines().nodes.empty()) return {};
  Trial trial{{}, slices_with_nodes(mesh.splines())};
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::vector<Box> region = perturbed_region(mesh.splines(), mesh.bricks(), axis);
    if (region.empty()) continue;
    trial.verdict = not_empty(mesh, axis, region.front());
    return trial;
  }
  return trial;
}

Trial uniform_unperturbed(MeshUnderTest& mesh) {
  if (mesh.outside_class()) return {Verdict::not_applicable("the mesh is not made by subdivisions")};
  const std::vector<std::int32_t>& levels = mesh.mesh().levels;
  if (std::any_of(levels.begin(), levels.end(), [&](std::int32_t level) { return level != levels.front(); })) {
    return {Verdict::not_applicable("the mesh is not uniform")};
  }
  return judge_unperturbed(mesh);
}

RefinementTree uniform_tree(const Setting& setting, int level) {
  RefinementTree tree(setting);
  for (int k = 0; k < level; ++k) {
    std::vector<std::int32_t> leaves;
    for (std::int32_t id = 0; id < tree.node_count(); ++id) {
      if (tree.is_leaf(id)) leaves.push_back(id);
    }
    subdivide_all(tree, leaves);
  }
  return tree;
}

namespace {

/// Adds the trials of every level whose uniform mesh has few enough elements; stops at a violation.
void try_levels(const Setting& setting, std::int64_t max_elements, Trial& total) {
  std::int64_t elements = std::int64_t{setting.domain[0]} * setting.domain[1] * setting.domain[2];
  for (int level = 0; elements <= max_elements; ++level, elements *= setting.grading) {
    const RefinementTree tree = uniform_tree(setting, level);
    MeshUnderTest mesh(tree);
    const Trial trial = uniform_unperturbed(mesh);
    total.met += trial.met;
    total.verdict = trial.verdict;
    if (trial.verdict.outcome == Outcome::violated) return;
  }
}

}  // namespace

Trial uniform_unperturbed_alone(Extent extent) {
  const std::int64_t max_elements = extent == Extent::short_run ? 3'000 : 60'000;
  Trial total;
  for (const PerAxis<int>& degree : {PerAxis<int>{3, 3, 3}, {5, 3, 3}, {3, 5, 3}, {3, 3, 5}, {3, 5, 7}, {7, 5, 3}}) {
    for (const PerAxis<int>& active : {PerAxis<int>{1, 1, 1}, {0, 0, 0}, {2, 1, 3}, {0, 4, 1}}) {
      Setting setting{degree, 2, {}};
      for (std::size_t axis = 0; axis < kDimension; ++axis) setting.domain[axis] = degree[axis] + 1 + active[axis];
      for (setting.grading = 2; setting.grading <= 5; ++setting.grading) {
        try_levels(setting, max_elements, total);
        if (total.verdict.outcome == Outcome::violated) return total;
      }
    }
  }
  return total;
}

}  // namespace asts
