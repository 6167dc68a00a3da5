#include <algorithm>
#include <set>
#include <stdexcept>

#include "tests/reference/tree.hpp"

namespace asts::reference {

namespace {

/// The tree with its boxes and environments in one unit, so that they are only compared.
template <class T>
struct Flat {
  std::vector<BasicBox<T>> boxes, environments;
  std::vector<bool> is_root;
  const RefinementTree& tree;

  Flat(const RefinementTree& source, Grid scale) : is_root(source.elements.size(), true), tree(source) {
    for (const TreeElement& element : source.elements) {
      boxes.push_back(in_units<T>(element.box, scale));
      environments.push_back(in_units<T>(element.environment, scale));
      for (const std::size_t child : element.children) is_root[child] = false;
    }
  }
};

template <class T>
bool closed_meets(const BasicBox<T>& closed, const BasicBox<T>& open) {
  for (std::size_t a = 0; a < dimension; ++a)
    if (!(closed.lower[a] < open.upper[a] && open.lower[a] < closed.upper[a])) return false;
  return true;
}

template <class T>
bool lies_in(const BasicBox<T>& inner, const BasicBox<T>& outer) {
  for (std::size_t a = 0; a < dimension; ++a)
    if (inner.lower[a] < outer.lower[a] || outer.upper[a] < inner.upper[a]) return false;
  return true;
}

/// Definition 3.1 on the mesh `current` of tree elements.
template <class T>
bool may_subdivide(const Flat<T>& flat, const std::vector<std::size_t>& current, std::size_t k) {
  for (const std::size_t other : current)
    if (flat.tree.elements[other].level < flat.tree.elements[k].level &&
        closed_meets(flat.boxes[other], flat.environments[k]))
      return false;
  return true;
}

template <class T>
std::vector<std::size_t> roots(const Flat<T>& flat) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < flat.boxes.size(); ++i)
    if (flat.is_root[i]) result.push_back(i);
  return result;
}

void replace_by_children(const RefinementTree& tree, std::vector<std::size_t>& current, std::size_t at) {
  const std::vector<std::size_t>& below = tree.elements[current[at]].children;
  current.erase(current.begin() + static_cast<std::ptrdiff_t>(at));
  current.insert(current.end(), below.begin(), below.end());
}

template <class T>
bool reaches_mesh(const Flat<T>& flat) {
  std::vector<std::size_t> current = roots(flat);
  for (bool progress = true; progress;) {
    progress = false;
    for (std::size_t i = 0; i < current.size(); ++i) {
      if (flat.tree.elements[current[i]].children.empty() || !may_subdivide(flat, current, current[i])) continue;
      replace_by_children(flat.tree, current, i);
      progress = true;
      --i;
    }
  }
  return std::all_of(current.begin(), current.end(),
                     [&](std::size_t i) { return flat.tree.elements[i].position.has_value(); });
}

bool reaches_mesh_in_some_order(const Flat<Rational>& flat, const std::vector<std::size_t>& current,
                                std::set<std::set<std::size_t>>& seen) {
  if (!seen.emplace(current.begin(), current.end()).second) return false;
  bool finished = true;
  for (std::size_t i = 0; i < current.size(); ++i) {
    if (flat.tree.elements[current[i]].children.empty()) continue;
    finished = false;
    if (!may_subdivide(flat, current, current[i])) continue;
    std::vector<std::size_t> next = current;
    replace_by_children(flat.tree, next, i);
    if (reaches_mesh_in_some_order(flat, next, seen)) return true;
  }
  return finished;
}

template <class T>
std::optional<NotNested> find_not_nested(const Flat<T>& flat, const std::vector<BasicBox<T>>& mesh) {
  std::vector<std::vector<std::size_t>> patches(flat.boxes.size());
  for (std::size_t k = 0; k < flat.boxes.size(); ++k)
    for (std::size_t i = 0; i < mesh.size(); ++i)
      if (closed_meets(mesh[i], flat.environments[k])) patches[k].push_back(i);
  for (std::size_t k = 0; k < flat.boxes.size(); ++k)
    for (std::size_t l = 0; l < flat.boxes.size(); ++l) {
      if (k == l || !lies_in(flat.boxes[k], flat.boxes[l])) continue;
      if (std::includes(patches[l].begin(), patches[l].end(), patches[k].begin(), patches[k].end())) continue;
      std::vector<std::size_t> only;
      std::set_difference(patches[k].begin(), patches[k].end(), patches[l].begin(), patches[l].end(),
                          std::back_inserter(only));
      return NotNested{k, l, only.front()};
    }
  return std::nullopt;
}

template <class T>
std::optional<NotNested> find_not_nested(const RefinementTree& tree, const Mesh& mesh, Grid scale) {
  std::vector<BasicBox<T>> boxes;
  for (const Box& box : mesh) boxes.push_back(in_units<T>(box, scale));
  return find_not_nested(Flat<T>(tree, scale), boxes);
}

}  // namespace

bool admissible_mesh(const Setting& setting, const Mesh& mesh, const RefinementTree& tree) {
  if (!tree.outside.empty()) return false;
  if (const auto scale = grid_scale(setting, mesh)) return reaches_mesh(Flat<Grid>(tree, *scale));
  return reaches_mesh(Flat<Rational>(tree, 1));
}

bool admissible_mesh_exhaustive(const Setting&, const RefinementTree& tree) {
  if (!tree.outside.empty()) return false;
  const auto inner = std::count_if(tree.elements.begin(), tree.elements.end(),
                                   [](const TreeElement& element) { return !element.children.empty(); });
  if (inner > 20) throw std::invalid_argument("too many inner elements to try every order");
  const Flat<Rational> flat(tree, 1);
  std::set<std::set<std::size_t>> seen;
  return reaches_mesh_in_some_order(flat, roots(flat), seen);
}

std::optional<NotNested> patches_not_nested(const Setting& setting, const Mesh& mesh, const RefinementTree& tree) {
  if (const auto scale = grid_scale(setting, mesh)) return find_not_nested<Grid>(tree, mesh, *scale);
  return find_not_nested<Rational>(tree, mesh, 1);
}

}  // namespace asts::reference
