#include "tests/reference/theorem_5_3_claims.hpp"

#include <algorithm>

#include "tests/reference/refine.hpp"
#include "tests/reference/suitability.hpp"
#include "tests/reference/tree.hpp"

namespace asts::reference {

namespace {

using Nodes = std::vector<PointIn<Grid>>;
using Boxes = std::vector<BasicBox<Grid>>;

/// One mesh: its space and splines.
struct Side {
  Space<Grid> space;
  std::vector<ActiveNode<Grid>> splines;

  Side(const Setting& setting, const Mesh& mesh, Grid scale)
      : space(make_space<Grid>(setting, mesh, scale)), splines(active_splines(space).value()) {}
};

/// Everything the proof looks at, in units of 1/scale. Coordinates of the mesh are even (see grid_scale).
struct Step {
  Setting setting;
  Grid scale;
  Side before, after;
  BasicBox<Grid> k;
  std::size_t x, y, z;   ///< the axes in the proof's roles
  std::vector<Grid> xi;  ///< Xi~
  Nodes created;         ///< N^_A \ N_A
};

Step make_step(const Setting& setting, const Mesh& mesh, std::size_t element) {
  const Mesh refined = subdivide(setting, mesh, {element});
  const Grid scale = grid_scale(setting, refined).value();
  const auto x = static_cast<std::size_t>(level(setting, mesh[element]).value() % 3);
  Step step{setting,
            scale,
            Side(setting, mesh, scale),
            Side(setting, refined, scale),
            in_units<Grid>(mesh[element], scale),
            x,
            (x + 1) % 3,
            (x + 2) % 3,
            {},
            {}};
  const Rational lower = mesh[element].lower[x], size = mesh[element].upper[x] - lower;
  for (int j = 1; j < setting.grading; ++j) step.xi.push_back(on_grid(lower + size * j / setting.grading, scale));
  const Nodes old_nodes = active_nodes(step.before.space), new_nodes = active_nodes(step.after.space);
  for (const PointIn<Grid>& v : new_nodes)
    if (std::find(old_nodes.begin(), old_nodes.end(), v) == old_nodes.end()) step.created.push_back(v);
  return step;
}

bool any_contains(const Boxes& boxes, const PointIn<Grid>& point) {
  for (const BasicBox<Grid>& box : boxes)
    if (in_closed(box, point)) return true;
  return false;
}

/// All ends along an axis and the middles between neighbouring ones. Two unions of boxes that differ in a point differ
/// in one made of such coordinates: membership is constant between neighbouring ends.
std::vector<Grid> places(const Boxes& first, const Boxes& second, std::size_t axis) {
  std::vector<Grid> ends;
  for (const Boxes* boxes : {&first, &second})
    for (const BasicBox<Grid>& box : *boxes) ends.insert(ends.end(), {box.lower[axis], box.upper[axis]});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Grid> result = ends;
  for (std::size_t i = 1; i < ends.size(); ++i) result.push_back((ends[i - 1] + ends[i]) / 2);
  return result;
}

/// Is the union of the first boxes a subset of the union of the second ones?
bool subset(const Boxes& first, const Boxes& second) {
  const std::vector<Grid> xs = places(first, second, 0), ys = places(first, second, 1), zs = places(first, second, 2);
  for (const Grid x : xs)
    for (const Grid y : ys)
      for (const Grid z : zs)
        if (any_contains(first, {x, y, z}) && !any_contains(second, {x, y, z})) return false;
  return true;
}

bool same_boxes(const Boxes& first, const Boxes& second) {
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const auto& a, const auto& b) { return a.lower == b.lower && a.upper == b.upper; });
}

bool same_set(const Boxes& first, const Boxes& second) {
  return same_boxes(first, second) || (subset(first, second) && subset(second, first));
}

Boxes region(const Side& side, std::size_t axis, Grid q) {
  return slice_perturbation(side.space, side.splines, axis, q);
}

bool regions_kept(const Step& step) {
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    std::vector<Grid> all = slices(step.before.space, axis);
    for (const Grid q : slices(step.after.space, axis)) all.push_back(q);
    for (const Grid q : all) {
      if (axis == step.x && std::find(step.xi.begin(), step.xi.end(), q) != step.xi.end()) continue;
      if (!same_set(region(step.before, axis, q), region(step.after, axis, q))) return false;
    }
  }
  return true;
}

/// The slice S_x(xi) cut with the supports, in the hatted mesh, of the nodes of a list.
Boxes cut_supports(const Step& step, Grid xi, const Nodes& nodes) {
  BasicBox<Grid> slice = step.after.space.active;
  if (xi < slice.lower[step.x] || slice.upper[step.x] < xi) return {};
  slice.lower[step.x] = slice.upper[step.x] = xi;
  Boxes result;
  for (const ActiveNode<Grid>& v : step.after.splines)
    if (std::find(nodes.begin(), nodes.end(), v.node) != nodes.end())
      if (const auto part = closed_intersection(slice, v.support)) result.push_back(*part);
  return result;
}

bool sigma_misses_others(const Step& step, Grid xi) {
  const Boxes sigma = cut_supports(step, xi, step.created);
  if (sigma.empty()) return true;
  for (const std::size_t axis : {step.y, step.z})
    for (const Grid q : slices(step.after.space, axis))
      for (const BasicBox<Grid>& part : region(step.after, axis, q))
        for (const BasicBox<Grid>& s : sigma)
          if (closed_intersection(part, s)) return false;
  return true;
}

/// N_x(xi).
Nodes slice_nodes(const Step& step, const Side& side, Grid xi) {
  Nodes result;
  for (const PointIn<Grid>& v : active_nodes(side.space))
    if (in_slice_nodes(side.space, step.x, xi, v)) result.push_back(v);
  return result;
}

Nodes minus(const Nodes& all, const Nodes& without) {
  Nodes result;
  for (const PointIn<Grid>& v : all)
    if (std::find(without.begin(), without.end(), v) == without.end()) result.push_back(v);
  return result;
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

/// P: the old active nodes with (v_2, v_3) in [y, y+y~] x [z, z+z~].
Nodes projected_nodes(const Step& step) {
  Nodes result;
  for (const PointIn<Grid>& v : active_nodes(step.before.space)) {
    bool inside = true;
    for (const std::size_t axis : {step.y, step.z})
      inside = inside && step.k.lower[axis] <= v[axis] && v[axis] <= step.k.upper[axis];
    if (inside) result.push_back(v);
  }
  return result;
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
  for (const BasicBox<Grid>& box : region(step.before, step.x, xi)) allowed.push_back(box);
  return subset(region(step.after, step.x, xi), allowed);
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
