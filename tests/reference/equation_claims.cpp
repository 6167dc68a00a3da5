#include "tests/reference/equation_claims.hpp"

#include <algorithm>
#include <functional>

namespace asts::reference {

Point size(const Box& box) {
  return {box.upper[0] - box.lower[0], box.upper[1] - box.lower[1], box.upper[2] - box.lower[2]};
}

Point printed_size(const Setting& s, int l) {
  const Rational whole = 1, part = Rational(1) / s.grading;
  const Point shape = l % 3 == 0   ? Point{whole, whole, whole}
                      : l % 3 == 1 ? Point{part, whole, whole}
                                   : Point{part, part, whole};
  const Rational scale = power(s.grading, -(l - l % 3) / 3);
  return {scale * shape[0], scale * shape[1], scale * shape[2]};
}

Point printed_parent_distance(const Setting& s, int l) {
  if (l % 3 == 0) return {power(s.grading, -(l + 6) / 3), 0, 0};
  if (l % 3 == 1) return {0, power(s.grading, -(l + 5) / 3), 0};
  return {0, 0, power(s.grading, -(l + 4) / 3)};
}

Point printed_child_distance(const Setting& s, int l) {
  if (l % 3 == 0) return {0, 0, power(s.grading, -(l + 3) / 3)};
  if (l % 3 == 1) return {power(s.grading, -(l + 5) / 3), 0, 0};
  return {0, power(s.grading, -(l + 4) / 3), 0};
}

RootSum p_tilde(const Setting& s, int axis) {
  return root_power(s.grading, axis) * (s.degree[static_cast<std::size_t>(axis)] + Rational(3) / 2);
}

RootSum half_size(const Setting& s, int axis) { return root_power(s.grading, axis + 1) * (Rational(1) / 2); }

namespace {

/// K^ and K in child(K^) with j, its number in Definition 2.5.
using Family = std::function<bool(const Box& parent, int parent_level, const Box& child, int j)>;

bool for_all_families(const Setting& setting, const Mesh& mesh, const Family& holds) {
  const RefinementTree tree = refinement_tree(setting, mesh);
  for (const TreeElement& parent : tree.elements) {
    const std::vector<Box> children = reference::children(setting, parent.box);
    for (const std::size_t position : parent.children) {
      const Box& child = tree.elements[position].box;
      const auto number = std::find(children.begin(), children.end(), child) - children.begin() + 1;
      if (!holds(parent.box, parent.level, child, static_cast<int>(number))) return false;
    }
  }
  return true;
}

/// x <= factor m^(-k/3), by comparing cubes.
bool at_most(const Setting& s, const Rational& x, const Rational& factor, int k) {
  return x * x * x <= factor * factor * factor * power(s.grading, -k);
}

bool at_most(const Rational& x, const RootSum& bound) { return sign(bound - RootSum{bound.m, x}) >= 0; }

bool level_bounds_hold(const Setting& s, int k) {
  const Point radius = environment_radius(s, k), own = printed_size(s, k), before = printed_size(s, k == 0 ? 0 : k - 1);
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (!at_most(radius[a], root_power(s.grading, -k) * p_tilde(s, axis))) return false;
    if (!at_most(own[a], root_power(s.grading, -k) * root_power(s.grading, axis))) return false;
    if (own[a] > before[a]) return false;
  }
  return true;
}

bool patch_distances_hold(const Setting& s, const Mesh& mesh, const Box& k) {
  const RootSum scale = root_power(s.grading, -level(s, k).value());
  for (int axis = 0; axis < 3; ++axis) {
    const RootSum bound = scale * (p_tilde(s, axis) + half_size(s, axis));
    for (const std::size_t other : patch(s, mesh, k))
      if (!at_most(distance(k, midpoint(mesh[other]))[static_cast<std::size_t>(axis)], bound)) return false;
  }
  return true;
}

}  // namespace

bool size_formula_holds(const Setting& s, const Mesh& mesh) {
  return for_all_families(
      s, mesh, [&](const Box&, int l, const Box& child, int) { return size(child) == printed_size(s, l + 1); });
}

bool child_distance_holds(const Setting& s, const Mesh& mesh) {
  return for_all_families(s, mesh, [&](const Box& parent, int l, const Box& child, int) {
    const Point actual = distance(child, midpoint(parent));
    return actual == printed_parent_distance(s, l) && actual == printed_child_distance(s, l + 1);
  });
}

bool child_distance_repaired_holds(const Setting& s, const Mesh& mesh) {
  return for_all_families(s, mesh, [&](const Box& parent, int l, const Box& child, int j) {
    Point expected{0, 0, 0};
    const auto axis = static_cast<std::size_t>(l % 3);
    const int steps = 2 * j - 1 - s.grading;
    expected[axis] = size(parent)[axis] * (steps < 0 ? -steps : steps) / (2 * s.grading);
    return distance(child, midpoint(parent)) == expected;
  });
}

bool radius_step_holds(const Setting& s, const Mesh& mesh) {
  return for_all_families(s, mesh, [&](const Box& parent, int l, const Box& child, int) {
    const Point step = distance(child, midpoint(parent));
    const Point inner = environment_radius(s, l + 1), outer = environment_radius(s, l);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (inner[axis] + step[axis] > outer[axis]) return false;
    return true;
  });
}

bool child_bound_holds(const Setting& s, const Mesh& mesh) {
  return for_all_families(s, mesh, [&](const Box& parent, int l, const Box& child, int) {
    const Point actual = distance(parent, midpoint(child));
    return at_most(s, actual[0], 1, l + 1 + 5) && at_most(s, actual[1], 1, l + 1 + 4) &&
           at_most(s, actual[2], 1, l + 1 + 3);
  });
}

bool child_bound_repaired_holds(const Setting& s, const Mesh& mesh) {
  const Rational factor = Rational(s.grading - 1) / 2;
  return for_all_families(s, mesh, [&](const Box& parent, int l, const Box& child, int) {
    const Point actual = distance(parent, midpoint(child));
    return at_most(s, actual[0], factor, l + 1 + 2) && at_most(s, actual[1], factor, l + 1 + 1) &&
           at_most(s, actual[2], factor, l + 1);
  });
}

bool radius_bounds_hold(const Setting& s, const Mesh& mesh) {
  for (const Box& k : mesh)
    if (!level_bounds_hold(s, level(s, k).value()) || !patch_distances_hold(s, mesh, k)) return false;
  return true;
}

bool has_children(const Setting& s, const Mesh& mesh) {
  for (const TreeElement& element : refinement_tree(s, mesh).elements)
    if (!element.children.empty()) return true;
  return false;
}

}  // namespace asts::reference
