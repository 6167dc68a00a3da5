#include <algorithm>

#include "tests/reference/suitability.hpp"

namespace asts::reference {

namespace {

/// The coordinates of one axis that a common point of two perturbed regions can have, and for each of them and each
/// node, whether the support reaches it and whether the node is in N_axis of it.
template <class T>
struct AxisTable {
  std::vector<T> coordinates;
  std::vector<std::vector<char>> reaches, in_nodes;
};

template <class T>
AxisTable<T> axis_table(const Space<T>& space, const std::vector<ActiveNode<T>>& splines, std::size_t axis) {
  AxisTable<T> table;
  table.coordinates = slices(space, axis);
  if (space.active.lower[axis] <= space.active.upper[axis]) table.coordinates.push_back(space.active.lower[axis]);
  for (const ActiveNode<T>& v : splines) {
    const T& lower = v.support.lower[axis];
    if (space.active.lower[axis] <= lower && lower <= space.active.upper[axis]) table.coordinates.push_back(lower);
  }
  std::sort(table.coordinates.begin(), table.coordinates.end());
  table.coordinates.erase(std::unique(table.coordinates.begin(), table.coordinates.end()), table.coordinates.end());
  for (const T& q : table.coordinates) {
    std::vector<char> reaches, in_nodes;
    for (const ActiveNode<T>& v : splines) {
      reaches.push_back(v.support.lower[axis] <= q && q <= v.support.upper[axis]);
      // By Definition 4.3, (q, v2, v3) is in the skeleton exactly when q is in X(v2, v3).
      in_nodes.push_back(std::binary_search(v.index_sets[axis].begin(), v.index_sets[axis].end(), q));
    }
    table.reaches.push_back(reaches);
    table.in_nodes.push_back(in_nodes);
  }
  return table;
}

using Positions = std::vector<std::size_t>;

Positions reaching(const Positions& among, const std::vector<char>& reaches) {
  Positions result;
  for (const std::size_t v : among)
    if (reaches[v]) result.push_back(v);
  return result;
}

/// Do the nodes, whose supports all contain the point, lie on both sides of N_axis?
bool perturbed(const Positions& at_point, const std::vector<char>& in_nodes) {
  bool in = false, out = false;
  for (const std::size_t v : at_point) (in_nodes[v] ? in : out) = true;
  return in && out;
}

}  // namespace

template <class T>
std::optional<PointIn<T>> perturbed_regions_meet(const Space<T>& space, const std::vector<ActiveNode<T>>& splines) {
  const AxisTable<T> x = axis_table(space, splines, 0), y = axis_table(space, splines, 1),
                     z = axis_table(space, splines, 2);
  Positions all(splines.size());
  for (std::size_t v = 0; v < all.size(); ++v) all[v] = v;
  for (std::size_t i = 0; i < x.coordinates.size(); ++i) {
    const Positions at_x = reaching(all, x.reaches[i]);
    for (std::size_t j = 0; j < y.coordinates.size(); ++j) {
      const Positions at_xy = reaching(at_x, y.reaches[j]);
      for (std::size_t k = 0; k < z.coordinates.size(); ++k) {
        const Positions at_point = reaching(at_xy, z.reaches[k]);
        const int regions = int{perturbed(at_point, x.in_nodes[i])} + int{perturbed(at_point, y.in_nodes[j])} +
                            int{perturbed(at_point, z.in_nodes[k])};
        if (regions >= 2) return PointIn<T>{x.coordinates[i], y.coordinates[j], z.coordinates[k]};
      }
    }
  }
  return std::nullopt;
}

template std::optional<PointIn<Rational>> perturbed_regions_meet(const Space<Rational>&,
                                                                 const std::vector<ActiveNode<Rational>>&);
template std::optional<PointIn<Grid>> perturbed_regions_meet(const Space<Grid>&, const std::vector<ActiveNode<Grid>>&);

}  // namespace asts::reference
