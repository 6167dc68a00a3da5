#include "tests/reference/tree.hpp"

#include <algorithm>

namespace asts::reference {

namespace {

Rational floor_of(const Rational& value) {
  Integer result;
  mpz_fdiv_q(result.backend().data(), mpq_numref(value.backend().data()), mpq_denref(value.backend().data()));
  return Rational(result);
}

Box unit_cube_at(const Point& lower) {
  Box cube;
  for (std::size_t a = 0; a < dimension; ++a) {
    cube.lower[a] = floor_of(lower[a]);
    cube.upper[a] = cube.lower[a] + 1;
  }
  return cube;
}

struct Builder {
  const Setting& setting;
  const Mesh& mesh;
  RefinementTree tree;

  /// Enters K and what lies below it into the tree; nothing when no box of the class lies in K. The box is cut along
  /// x, y, z for level 0, 1, 2 modulo 3; `inside` are the positions of the mesh's boxes contained in K.
  std::optional<std::size_t> grow(const Box& k, int k_level, const std::vector<std::size_t>& inside) {
    if (inside.empty()) return std::nullopt;
    if (inside.size() == 1 && mesh[inside[0]] == k) return enter(k, k_level, inside[0], {});
    std::vector<std::size_t> below, rest = inside;
    for (const Box& child : subdivide_along(setting, k, static_cast<std::size_t>(k_level % 3))) {
      const auto split = std::stable_partition(rest.begin(), rest.end(),
                                               [&](std::size_t i) { return !contains(child, mesh[i]); });
      if (const auto entered = grow(child, k_level + 1, {split, rest.end()})) below.push_back(*entered);
      rest.erase(split, rest.end());
    }
    tree.outside.insert(tree.outside.end(), rest.begin(), rest.end());  // in K, not K, in no child of K
    if (below.empty()) return std::nullopt;
    return enter(k, k_level, std::nullopt, below);
  }

  std::size_t enter(const Box& k, int k_level, std::optional<std::size_t> position, std::vector<std::size_t> below) {
    tree.elements.push_back({k, k_level, environment(setting, k), position, std::move(below)});
    return tree.elements.size() - 1;
  }
};

}  // namespace

RefinementTree refinement_tree(const Setting& setting, const Mesh& mesh) {
  Builder builder{setting, mesh, {}};
  std::vector<std::pair<Box, std::size_t>> by_cube;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const Box cube = unit_cube_at(mesh[i].lower);
    if (contains(cube, mesh[i]))
      by_cube.emplace_back(cube, i);
    else
      builder.tree.outside.push_back(i);
  }
  std::sort(by_cube.begin(), by_cube.end());
  for (std::size_t i = 0; i < by_cube.size();) {
    std::vector<std::size_t> inside;
    const Box cube = by_cube[i].first;
    for (; i < by_cube.size() && by_cube[i].first == cube; ++i) inside.push_back(by_cube[i].second);
    builder.grow(cube, 0, inside);
  }
  std::sort(builder.tree.outside.begin(), builder.tree.outside.end());
  return builder.tree;
}

bool in_class(const Setting& setting, const Box& box) {
  Box current = unit_cube_at(box.lower);
  for (std::size_t a = 0; a < dimension; ++a)
    if (box.lower[a] < 0 || box.upper[a] > setting.domain[a] || box.lower[a] >= box.upper[a]) return false;
  if (!contains(current, box)) return false;
  for (std::size_t axis = 0; !(current == box); axis = (axis + 1) % dimension) {
    const std::vector<Box> parts = subdivide_along(setting, current, axis);
    const auto next = std::find_if(parts.begin(), parts.end(), [&](const Box& part) { return contains(part, box); });
    if (next == parts.end()) return false;
    current = *next;
  }
  return true;
}

}  // namespace asts::reference
