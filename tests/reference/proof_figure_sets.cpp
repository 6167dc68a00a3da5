#include <algorithm>

#include "tests/reference/proof_figure.hpp"

namespace asts::reference {

namespace {

using Place = std::array<Rational, 2>;

constexpr int squares[2] = {17, 21};

bool is_patch(const std::string& name) { return name == "patch" || name == "second-order patch"; }

/// The part on the slice of the patch of K, or of the union of the patches of its elements.
DrawnSet found_patch(const ProofFigureMesh& f, bool second) {
  std::vector<std::size_t> positions = patch(f.setting, f.mesh, f.k);
  if (second) {
    std::vector<std::size_t> all;
    for (const std::size_t inner : positions) {
      const std::vector<std::size_t> more = patch(f.setting, f.mesh, f.mesh[inner]);
      all.insert(all.end(), more.begin(), more.end());
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    positions = all;
  }
  DrawnSet result;
  for (const std::size_t position : positions) {
    const Box& box = f.mesh[position];
    if (box.lower[0] > f.xi || f.xi > box.upper[0]) continue;
    result.push_back(
        {{box.lower[1] - f.margin, box.lower[2] - f.margin}, {box.upper[1] - f.margin, box.upper[2] - f.margin}});
  }
  return result;
}

/// Boxes seen along x, each rectangle once.
DrawnSet shadows(const ProofFigureMesh& f, const std::vector<BasicBox<Grid>>& boxes, Grid scale) {
  std::vector<std::array<Grid, 4>> seen;
  for (const BasicBox<Grid>& box : boxes) seen.push_back({box.lower[1], box.lower[2], box.upper[1], box.upper[2]});
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  const auto drawn = [&](Grid value) { return Rational(Rational(value) / scale - f.margin); };
  DrawnSet result;
  for (const auto& [y, z, y_end, z_end] : seen) result.push_back({{drawn(y), drawn(z)}, {drawn(y_end), drawn(z_end)}});
  return result;
}

/// Sigma: the slice at xi cut with the supports of the active nodes that K's subdivision has made.
std::vector<BasicBox<Grid>> new_supports(const ProofFigureMesh& f, const Space<Grid>& space, Grid scale,
                                         const std::vector<ActiveNode<Grid>>& splines) {
  Mesh before;
  for (const Box& element : f.mesh)
    if (!contains(f.k, element)) before.push_back(element);
  before.push_back(f.k);
  const std::vector<PointIn<Grid>> old_nodes = active_nodes(make_space<Grid>(f.setting, before, scale));
  BasicBox<Grid> slice = space.active;
  slice.lower[0] = slice.upper[0] = on_grid(f.xi, scale);
  std::vector<BasicBox<Grid>> result;
  for (const ActiveNode<Grid>& v : splines)
    if (!std::binary_search(old_nodes.begin(), old_nodes.end(), v.node))
      if (const auto part = closed_intersection(slice, v.support)) result.push_back(*part);
  return result;
}

}  // namespace

DrawnSet found_set(const ProofFigureMesh& f, const std::string& name) {
  if (is_patch(name)) return found_patch(f, name == "second-order patch");
  const Grid scale = grid_scale(f.setting, f.mesh).value();
  const Space<Grid> space = make_space<Grid>(f.setting, f.mesh, scale);
  const std::vector<ActiveNode<Grid>> splines = active_splines(space).value();
  if (name == "Sigma") return shadows(f, new_supports(f, space, scale, splines), scale);
  const std::size_t axis = name == "Rx" ? 0 : name == "Ry" ? 1 : 2;
  std::vector<BasicBox<Grid>> region;
  for (const Grid q : slices(space, axis)) {
    const auto part = slice_perturbation(space, splines, axis, q);
    region.insert(region.end(), part.begin(), part.end());
  }
  return shadows(f, region, scale);
}

bool comparable(const ProofFigureMesh& f, const std::string& name, const Place& place) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (place[i] < 0 || squares[i] < place[i]) return false;
    const int frame = (f.setting.degree[i + 1] + 1) / 2;
    const Rational coordinate = place[i] + f.margin;
    if (!is_patch(name) && (coordinate < frame || f.setting.domain[i + 1] - frame < coordinate)) return false;
  }
  return true;
}

bool in_set(const DrawnSet& set, const Place& place) {
  return std::any_of(set.begin(), set.end(), [&](const DrawnRectangle& part) { return part.contains(place); });
}

bool same_sets(const ProofFigureMesh& f, const std::string& name, const DrawnSet& drawn) {
  const DrawnSet found = found_set(f, name);
  const int step = is_patch(name) ? 2 : 1;  // the middles of half squares: odd quarters
  for (int y = step - 1; y <= 4 * squares[0]; y += step)
    for (int z = step - 1; z <= 4 * squares[1]; z += step) {
      const Place place{Rational(y, 4), Rational(z, 4)};
      if (comparable(f, name, place) && in_set(found, place) != in_set(drawn, place)) return false;
    }
  return true;
}

}  // namespace asts::reference
