#include "tests/reference/complexity_claims.hpp"

#include <algorithm>

namespace asts::reference {

namespace {

bool at_most(const Rational& x, const RootSum& bound) { return sign(bound - RootSum{bound.m, x}) >= 0; }

/// G \ G_0 and the like: the boxes of `mesh` that are not in `old`.
Mesh without(const Mesh& mesh, Mesh old) {
  std::sort(old.begin(), old.end());
  Mesh rest;
  for (const Box& box : mesh)
    if (!std::binary_search(old.begin(), old.end(), box)) rest.push_back(box);
  return rest;
}

/// l(K) <= l(K') + 1 and Dist(K,K') <= scale m^(-l(K)/3) (d_1,d_2,d_3).
bool close(const Setting& s, const Box& k, const Box& other, const Rational& scale) {
  const int own = level(s, k).value();
  if (own > level(s, other).value() + 1) return false;
  const Point between = distance(k, midpoint(other));
  for (int axis = 0; axis < 3; ++axis) {
    const RootSum bound = root_power(s.grading, -own) * distance_constant(s, axis) * scale;
    if (!at_most(between[static_cast<std::size_t>(axis)], bound)) return false;
  }
  return true;
}

RootSum lambda(const Setting& s, const Box& k, const Box& mark, const Rational& reach) {
  if (!close(s, k, mark, 2 * reach)) return {s.grading};
  return root_power(s.grading, level(s, k).value() - level(s, mark).value());
}

}  // namespace

namespace {

/// `child` stands for what the children's distance adds, over m^(1/3) - 1.
RootSum constant_with(const Setting& s, int axis, const Rational& child) {
  const int m = s.grading;
  const RootSum t = root_power(m, 1), one{m, 1};
  const RootSum sum = RootSum{m, Rational(s.degree[static_cast<std::size_t>(axis)])} +
                      (RootSum{m, 3} + t) * (Rational(1) / 2) + (t - one) * child;
  return root_power(m, axis) * geometric_sum(m) * sum;
}

}  // namespace

RootSum distance_constant(const Setting& s, int axis) {
  return constant_with(s, axis, Rational(1) / s.grading / s.grading);
}

RootSum repaired_distance_constant(const Setting& s, int axis) {
  return constant_with(s, axis, Rational(s.grading - 1) / 2 / s.grading);
}

RootSum complexity_constant(const Setting& s, DistanceConstant d) {
  const int m = s.grading;
  RootSum product = root_power(m, 1) * geometric_sum(m);
  for (int axis = 0; axis < 3; ++axis) product = product * (d(s, axis) * Rational(4) + root_power(m, axis));
  return product;
}

bool distance_bound_holds(const Setting& s, const Mesh& mesh, const std::vector<std::size_t>& marked,
                          const Rational& scale) {
  for (const Box& k : without(refine(s, mesh, marked), mesh)) {
    const bool found =
        std::any_of(marked.begin(), marked.end(), [&](std::size_t mark) { return close(s, k, mesh[mark], scale); });
    if (!found) return false;
  }
  return true;
}

bool complexity_bound_holds(const Sequence& sequence, const Rational& scale) {
  std::size_t marks = 0;
  for (std::size_t j = 1; j < sequence.meshes.size(); ++j) {
    marks += sequence.marks[j - 1].size();
    const std::size_t fresh = without(sequence.meshes[j], sequence.meshes[0]).size();
    if (!at_most(Rational(fresh), complexity_constant(sequence.setting) * (scale * Rational(marks)))) return false;
  }
  return true;
}

bool lambda_sums_hold(const Sequence& sequence, const Rational& reach, const Rational& scale) {
  const Setting& s = sequence.setting;
  const Mesh fresh = without(sequence.meshes.back(), sequence.meshes.front());
  Mesh marks;
  for (const Mesh& step : sequence.marks) marks.insert(marks.end(), step.begin(), step.end());
  for (const Box& k : fresh) {
    RootSum sum{s.grading};
    for (const Box& mark : marks) sum = sum + lambda(s, k, mark, reach);
    if (sign(sum - RootSum{s.grading, 1}) < 0) return false;
  }
  for (const Box& mark : marks) {
    RootSum sum{s.grading};
    for (const Box& k : fresh) sum = sum + lambda(s, k, mark, reach);
    if (sign(complexity_constant(s) * scale - sum) < 0) return false;
  }
  return true;
}

}  // namespace asts::reference
