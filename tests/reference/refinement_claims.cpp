#include "tests/reference/refinement_claims.hpp"

#include <algorithm>

#include "tests/reference/grid.hpp"
#include "tests/reference/refine.hpp"
#include "tests/reference/tree.hpp"

namespace asts::reference {

namespace {

using Positions = std::vector<std::size_t>;

bool contains_all(const Positions& larger, const Positions& smaller) {
  return std::includes(larger.begin(), larger.end(), smaller.begin(), smaller.end());
}

Mesh in_order(Mesh mesh) {
  std::sort(mesh.begin(), mesh.end());
  return mesh;
}

/// Definition 2.4 in any unit.
template <class T>
std::vector<Positions> patches_of(const std::vector<BasicBox<T>>& open, const std::vector<BasicBox<T>>& elements) {
  std::vector<Positions> result(open.size());
  for (std::size_t k = 0; k < open.size(); ++k)
    for (std::size_t i = 0; i < elements.size(); ++i) {
      bool meets = true;
      for (std::size_t a = 0; a < dimension; ++a)
        meets = meets && elements[i].lower[a] < open[k].upper[a] && open[k].lower[a] < elements[i].upper[a];
      if (meets) result[k].push_back(i);
    }
  return result;
}

template <class T>
std::vector<BasicBox<T>> all_in_units(const Mesh& boxes, Grid scale) {
  std::vector<BasicBox<T>> result;
  for (const Box& box : boxes) result.push_back(in_units<T>(box, scale));
  return result;
}

/// The patches, in the mesh, of boxes that may be no elements of it.
std::vector<Positions> patches_of(const Setting& setting, const Mesh& boxes, const Mesh& mesh) {
  Mesh open;
  for (const Box& box : boxes) open.push_back(environment(setting, box));
  Mesh all = mesh;
  all.insert(all.end(), boxes.begin(), boxes.end());
  if (const auto scale = grid_scale(setting, all))
    return patches_of(all_in_units<Grid>(open, *scale), all_in_units<Grid>(mesh, *scale));
  return patches_of(all_in_units<Rational>(open, 1), all_in_units<Rational>(mesh, 1));
}

/// The greatest closed set without k: elements that need what is missing go until none does.
std::vector<bool> greatest_closed_without(const Patches& patches, std::size_t k) {
  std::vector<bool> in(patches.of.size(), true);
  in[k] = false;
  for (bool shrank = true; shrank;) {
    shrank = false;
    for (std::size_t i = 0; i < in.size(); ++i) {
      if (!in[i]) continue;
      for (const std::size_t needed : patches.coarser[i])
        if (!in[needed]) in[i] = false;
      shrank = shrank || !in[i];
    }
  }
  return in;
}

/// Algorithm 2.8, with the patches at hand.
Positions closure_of(const Patches& patches, const Positions& marks) {
  std::vector<bool> marked(patches.of.size(), false);
  for (const std::size_t mark : marks) marked[mark] = true;
  for (bool grew = true; grew;) {
    grew = false;
    for (std::size_t k = 0; k < marked.size(); ++k) {
      if (!marked[k]) continue;
      for (const std::size_t other : patches.coarser[k]) {
        grew = grew || !marked[other];
        marked[other] = true;
      }
    }
  }
  Positions result;
  for (std::size_t k = 0; k < marked.size(); ++k)
    if (marked[k]) result.push_back(k);
  return result;
}

bool is_admissible(const Setting& setting, const Mesh& mesh) {
  return admissible_mesh(setting, mesh, refinement_tree(setting, mesh));
}

/// Makes the mesh by subdividing each inner element once, in the order of levels; `allowed` may end it.
template <class Allowed>
ClaimTrial rebuild(const Setting& setting, const Mesh& mesh, Allowed allowed) {
  ClaimTrial trial;
  Mesh current = initial_mesh(setting);
  for (const Box& k : inner_by_level(setting, mesh)) {
    trial.met += level(setting, k).value() > 0;
    const auto position = static_cast<std::size_t>(std::find(current.begin(), current.end(), k) - current.begin());
    trial.holds = position < current.size() && allowed(current, position);
    if (!trial.holds) return trial;
    current = subdivide(setting, current, {position});
  }
  trial.holds = in_order(current) == in_order(mesh);
  return trial;
}

void append_generations(const Setting& setting, const Box& box, int generations, Mesh& result) {
  if (generations == 0) return;
  for (const Box& child : children(setting, box)) {
    result.push_back(child);
    append_generations(setting, child, generations - 1, result);
  }
}

/// All pairs of different boxes one of which lies in the other.
template <class T>
ClaimTrial compare_nested(const std::vector<BasicBox<T>>& elements, const std::vector<Positions>& patches) {
  ClaimTrial trial;
  for (std::size_t inner = 0; inner < elements.size(); ++inner)
    for (std::size_t outer = 0; outer < elements.size(); ++outer) {
      bool nested = inner != outer;
      for (std::size_t a = 0; nested && a < dimension; ++a)
        nested = elements[outer].lower[a] <= elements[inner].lower[a] &&
                 elements[inner].upper[a] <= elements[outer].upper[a];
      if (!nested) continue;
      ++trial.met;
      trial.holds = trial.holds && contains_all(patches[outer], patches[inner]);
    }
  return trial;
}

}  // namespace

Patches patches(const Setting& setting, const Mesh& mesh) {
  Patches result;
  for (const Box& box : mesh) result.levels.push_back(level(setting, box).value());
  result.of = patches_of(setting, mesh, mesh);
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    result.coarser.emplace_back();
    for (const std::size_t other : result.of[k])
      if (result.levels[other] < result.levels[k]) result.coarser[k].push_back(other);
  }
  return result;
}

bool in_every_closed_superset(const Patches& patches, const Positions& marks, std::size_t element) {
  if (std::find(marks.begin(), marks.end(), element) != marks.end()) return true;
  const std::vector<bool> without = greatest_closed_without(patches, element);
  return !std::all_of(marks.begin(), marks.end(), [&](std::size_t mark) { return without[mark]; });
}

bool is_least_closed_superset(const Patches& patches, const Positions& marks, const Positions& set) {
  Positions sorted_marks = marks;
  std::sort(sorted_marks.begin(), sorted_marks.end());
  if (!contains_all(set, sorted_marks)) return false;
  for (const std::size_t k : set) {
    if (!contains_all(set, patches.coarser[k])) return false;
    if (!in_every_closed_superset(patches, marks, k)) return false;
  }
  return true;
}

Mesh inner_by_level(const Setting& setting, const Mesh& mesh) {
  std::vector<TreeElement> inner;
  for (const TreeElement& element : refinement_tree(setting, mesh).elements)
    if (!element.children.empty()) inner.push_back(element);
  std::sort(inner.begin(), inner.end(), [](const TreeElement& a, const TreeElement& b) {
    return a.level != b.level ? a.level < b.level : a.box < b.box;
  });
  Mesh result;
  for (const TreeElement& element : inner) result.push_back(element.box);
  return result;
}

ClaimTrial closure_least(const Setting& setting, const Mesh& mesh) {
  const Patches all = patches(setting, mesh);
  ClaimTrial trial;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const Positions closure = closure_of(all, {k});
    trial.met += closure.size() > 1;
    trial.holds = trial.holds && is_least_closed_superset(all, {k}, closure);
  }
  return trial;
}

ClaimTrial refine_admissible(const Setting& setting, const Mesh& mesh) {
  const Patches all = patches(setting, mesh);
  ClaimTrial trial;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    const Positions closure = closure_of(all, {k});
    trial.met += closure.size() > 1;
    trial.holds = trial.holds && is_admissible(setting, subdivide(setting, mesh, closure));
  }
  return trial;
}

ClaimTrial refine_generates(const Setting& setting, const Mesh& mesh) {
  return rebuild(setting, mesh, [&](const Mesh& current, std::size_t k) {
    return refine(setting, current, {k}) == subdivide(setting, current, {k});
  });
}

ClaimTrial level_order(const Setting& setting, const Mesh& mesh) {
  return rebuild(setting, mesh,
                 [&](const Mesh& current, std::size_t k) { return admissible_subdivision(setting, current, k); });
}

ClaimTrial patches_nested(const Setting& setting, const Mesh& mesh) {
  Mesh elements;
  for (const TreeElement& element : refinement_tree(setting, mesh).elements) {
    elements.push_back(element.box);
    if (element.position) append_generations(setting, element.box, 2, elements);
  }
  const std::vector<Positions> all = patches_of(setting, elements, mesh);
  if (const auto scale = grid_scale(setting, elements))
    return compare_nested(all_in_units<Grid>(elements, *scale), all);
  return compare_nested(all_in_units<Rational>(elements, 1), all);
}

ClaimTrial levels_change_slowly(const Setting& setting, const Mesh& mesh) {
  const Patches all = patches(setting, mesh);
  ClaimTrial trial;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    bool another_level = false;
    for (const std::size_t other : all.of[k]) {
      another_level = another_level || all.levels[other] != all.levels[k];
      trial.holds = trial.holds && all.levels[other] >= all.levels[k] - 1;
    }
    trial.met += another_level;
  }
  return trial;
}

}  // namespace asts::reference
