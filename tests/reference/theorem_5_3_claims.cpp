#include "tests/reference/theorem_5_3_claims.hpp"

#include <algorithm>

#include "tests/reference/refine.hpp"
#include "tests/reference/theorem_5_3_step.hpp"
#include "tests/reference/tree.hpp"

namespace asts::reference {

namespace {

bool same_boxes(const Boxes& first, const Boxes& second) {
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const auto& a, const auto& b) { return a.lower == b.lower && a.upper == b.upper; });
}

bool same_set(const Boxes& first, const Boxes& second) {
  return same_boxes(first, second) || (subset(first, second) && subset(second, first));
}

bool regions_kept(const Step& step) {
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    std::vector<Grid> all = slices(step.before.space, axis);
    for (const Grid q : slices(step.after.space, axis)) all.push_back(q);
    for (const Grid q : all) {
      if (axis == step.x && std::find(step.xi.begin(), step.xi.end(), q) != step.xi.end()) continue;
      if (!same_set(slice_region(step.before, axis, q), slice_region(step.after, axis, q))) return false;
    }
  }
  return true;
}

bool sigma_misses_others(const Step& step, Grid xi) {
  const Boxes sigma = cut_supports(step, xi, step.created);
  if (sigma.empty()) return true;
  for (const std::size_t axis : {step.y, step.z})
    for (const Grid q : slices(step.after.space, axis))
      for (const BasicBox<Grid>& part : slice_region(step.after, axis, q))
        for (const BasicBox<Grid>& s : sigma)
          if (closed_intersection(part, s)) return false;
  return true;
}

Nodes sorted_union(Nodes first, const Nodes& second) {
  first.insert(first.end(), second.begin(), second.end());
  std::sort(first.begin(), first.end());
  first.erase(std::unique(first.begin(), first.end()), first.end());
  return first;
}

bool split_as_printed(const Step& step, Grid xi) {
  const Nodes hatted = slice_nodes(step, step.after, xi), old = slice_nodes(step, step.before, xi);
  if (hatted != sorted_union(old, step.created)) return false;
  const Nodes all = active_nodes(step.before.space), hatted_all = active_nodes(step.after.space);
  return minus(hatted_all, hatted) == minus(all, hatted) && minus(all, hatted) == minus(all, old);
}

bool split_repaired(const Step& step, Grid xi) {
  const Nodes projected = projected_nodes(step);
  const Nodes hatted = slice_nodes(step, step.after, xi), old = slice_nodes(step, step.before, xi);
  const Nodes old_or_projected = sorted_union(old, projected);
  if (hatted != sorted_union(old_or_projected, step.created)) return false;
  const Nodes all = active_nodes(step.before.space), hatted_all = active_nodes(step.after.space);
  if (minus(hatted_all, hatted) != minus(all, old_or_projected)) return false;
  Boxes allowed = cut_supports(step, xi, step.created);
  if (!subset(cut_supports(step, xi, minus(projected, old)), allowed)) return false;
  for (const BasicBox<Grid>& box : slice_region(step.before, step.x, xi)) allowed.push_back(box);
  return subset(slice_region(step.after, step.x, xi), allowed);
}

bool within(Grid lower, Grid upper, Grid centre, Grid radius) {
  return centre - radius <= lower && upper <= centre + radius;
}

bool extents_hold(const Step& step, Grid xi) {
  std::array<Grid, dimension> eps, middle;
  for (std::size_t a = 0; a < dimension; ++a) {
    eps[a] = (step.k.upper[a] - step.k.lower[a]) / 2;
    middle[a] = (step.k.upper[a] + step.k.lower[a]) / 2;
  }
  const std::array<int, dimension>& p = step.setting.degree;
  const Boxes sigma = cut_supports(step, xi, step.created);
  for (const BasicBox<Grid>& s : sigma)
    for (const std::size_t a : {step.y, step.z})
      if (!within(s.lower[a], s.upper[a], middle[a], eps[a] * (p[a] + 2))) return false;
  for (const ActiveNode<Grid>& w : step.after.splines)
    for (const BasicBox<Grid>& s : sigma) {
      if (!closed_intersection(w.support, s)) continue;
      const Grid w1 = w.node[step.x], w2 = w.node[step.y];
      if (!within(w1, w1, xi, eps[step.x] * (p[step.x] + 1))) return false;
      if (!within(w2, w2, middle[step.y], eps[step.y] * (2 * p[step.y] + 3))) return false;
    }
  return true;
}

bool second_patch_no_larger(const Setting& setting, const Mesh& mesh, std::size_t element, const Step& step) {
  for (const std::size_t inner : patch(setting, mesh, mesh[element]))
    for (const std::size_t other : patch(setting, mesh, mesh[inner]))
      for (const std::size_t axis : {step.x, step.y})
        if (mesh[other].upper[axis] - mesh[other].lower[axis] > mesh[element].upper[axis] - mesh[element].lower[axis])
          return false;
  return true;
}

}  // namespace

Theorem53Step decide_theorem_5_3_step(const Setting& setting, const Mesh& mesh, std::size_t element) {
  const Step step = make_step(setting, mesh, element);
  Theorem53Step result{
      regions_kept(step), true, true, true, second_patch_no_larger(setting, mesh, element, step), true};
  for (const Grid xi : step.xi) {
    result.sigma_unperturbed = result.sigma_unperturbed && sigma_misses_others(step, xi);
    result.split = result.split && split_as_printed(step, xi);
    result.split_repaired = result.split_repaired && split_repaired(step, xi);
    result.sigma_extent = result.sigma_extent && extents_hold(step, xi);
  }
  return result;
}

bool refutes_new_node_split(const Setting& setting, const Mesh& mesh) {
  if (!admissible_mesh(setting, mesh, refinement_tree(setting, mesh))) return false;
  const Side side(setting, mesh, grid_scale(setting, mesh).value());
  if (!analysis_suitable_by_rectangles(side.space, side.splines)) return false;
  for (std::size_t element = 0; element < mesh.size(); ++element) {
    if (level(setting, mesh[element]).value() % 3 != 0 || !admissible_subdivision(setting, mesh, element)) continue;
    const Step step = make_step(setting, mesh, element);
    for (const Grid xi : step.xi)
      if (!split_as_printed(step, xi)) return true;
  }
  return false;
}

}  // namespace asts::reference
