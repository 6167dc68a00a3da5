#include "tests/reference/overlay.hpp"

#include <algorithm>

#include "tests/reference/tree.hpp"

namespace asts::reference {

namespace {

Mesh in_order(Mesh mesh) {
  std::sort(mesh.begin(), mesh.end());
  return mesh;
}

bool is_third(const Mesh& both, const Mesh& one, const Mesh& other) {
  return both != in_order(one) && both != in_order(other);
}

}  // namespace

Mesh common_refinement(const Mesh& one, const Mesh& other) {
  Mesh result;
  for (const Box& a : one)
    for (const Box& b : other) {
      Box both;
      bool interior = true;
      for (std::size_t axis = 0; axis < dimension; ++axis) {
        both.lower[axis] = std::max(a.lower[axis], b.lower[axis]);
        both.upper[axis] = std::min(a.upper[axis], b.upper[axis]);
        interior = interior && both.lower[axis] < both.upper[axis];
      }
      if (interior) result.push_back(both);
    }
  return in_order(result);
}

Mesh mirrored(const Setting& setting, const Mesh& mesh, const std::array<bool, dimension>& axes) {
  Mesh result = mesh;
  for (Box& box : result)
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      if (!axes[axis]) continue;
      const Rational lower = setting.domain[axis] - box.upper[axis];
      box.upper[axis] = setting.domain[axis] - box.lower[axis];
      box.lower[axis] = lower;
    }
  return in_order(result);
}

ClaimTrial overlay_admissible(const Setting& setting, const Mesh& one, const Mesh& other) {
  const Mesh both = common_refinement(one, other);
  return {admissible_mesh(setting, both, refinement_tree(setting, both)), is_third(both, one, other)};
}

ClaimTrial overlay_cardinality(const Setting& setting, const Mesh& one, const Mesh& other) {
  const Mesh both = common_refinement(one, other);
  return {both.size() + initial_mesh(setting).size() <= one.size() + other.size(), is_third(both, one, other)};
}

}  // namespace asts::reference
