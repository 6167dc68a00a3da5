#include "tests/reference/theorem_5_3_step.hpp"

#include <algorithm>

namespace asts::reference {

Side::Side(const Setting& setting, const Mesh& mesh, Grid scale)
    : space(make_space<Grid>(setting, mesh, scale)), splines(active_splines(space).value()) {}

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

namespace {

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

}  // namespace

bool subset(const Boxes& first, const Boxes& second) {
  const std::vector<Grid> xs = places(first, second, 0), ys = places(first, second, 1), zs = places(first, second, 2);
  for (const Grid x : xs)
    for (const Grid y : ys)
      for (const Grid z : zs)
        if (any_contains(first, {x, y, z}) && !any_contains(second, {x, y, z})) return false;
  return true;
}

Boxes slice_region(const Side& side, std::size_t axis, Grid q) {
  return slice_perturbation(side.space, side.splines, axis, q);
}

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

Nodes slice_nodes(const Step& step, const Side& side, Grid xi) {
  Nodes result;
  for (const PointIn<Grid>& v : active_nodes(side.space))
    if (in_slice_nodes(side.space, step.x, xi, v)) result.push_back(v);
  return result;
}

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

Nodes minus(const Nodes& all, const Nodes& without) {
  Nodes result;
  for (const PointIn<Grid>& v : all)
    if (std::find(without.begin(), without.end(), v) == without.end()) result.push_back(v);
  return result;
}

}  // namespace asts::reference
