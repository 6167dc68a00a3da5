#include <algorithm>
#include <optional>

#include "properties/claims/on_class.hpp"
#include "properties/claims/patch_claims.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

/// m^-exponent.
Rational negative_power(int grading, int exponent) {
  Integer power = 1;
  for (int i = 0; i < exponent; ++i) power *= grading;
  return Rational(Integer(1), power);
}

/// p + 3/2 along one axis.
Rational reach(int degree) { return Rational(2 * degree + 3, 2); }

/// The sides of an element of level k: a unit cube, cut k times, along x, y, z in turn (Definition 2.6).
ExactPoint sides_of_level(int grading, int level) {
  ExactPoint sides;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const int cuts = (level + kDimension - 1 - axis) / kDimension;
    sides[at(axis)] = negative_power(grading, cuts);
  }
  return sides;
}

Verdict wrong_radius(const char* says, Axis axis, int degree, int level, int grading, const Rational& value,
                     const Rational& expected) {
  return Verdict::violated(ClaimWitness{"patch-radius",
                                        says,
                                        {{"axis", axis_name(axis)},
                                         {"degree along the axis", std::int64_t{degree}},
                                         {"level", std::int64_t{level}},
                                         {"grading", std::int64_t{grading}},
                                         {"value", value},
                                         {"compared with", expected}}});
}

Verdict wrong_end(const char* says, const RefinementTree& tree, std::int32_t k, Axis axis, const Rational& value,
                  const Rational& expected) {
  return Verdict::violated(ClaimWitness{"environment",
                                        says,
                                        {{"K", describe_tree_element(tree, k)},
                                         {"axis", axis_name(axis)},
                                         {"value", value},
                                         {"compared with", expected}}});
}

/// Where U(K) ends along one axis: the midpoint and D(k), cut off at the domain's ends.
std::optional<Verdict> wrong_environment(const RefinementTree& tree, std::int32_t k, const ExactPoint& radius) {
  const ExactBox box = describe_tree_element(tree, k).box;
  const ExactBox open = describe_environment(tree, k);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto a = at(axis);
    const Rational middle = (box.lower[a] + box.upper[a]) / 2;
    const Rational lower = std::max(Rational(middle - radius[a]), Rational(0));
    const Rational upper = std::min(Rational(middle + radius[a]), Rational(tree.setting().domain[a]));
    if (open.lower[a] != lower) return wrong_end("U(K) begins elsewhere", tree, k, axis, open.lower[a], lower);
    if (open.upper[a] != upper) return wrong_end("U(K) ends elsewhere", tree, k, axis, open.upper[a], upper);
  }
  return std::nullopt;
}

}  // namespace

ExactPoint radius_as_printed(const PerAxis<int>& degree, int grading, int level) {
  const Rational x = reach(degree[0]);
  const Rational y = reach(degree[1]);
  const Rational z = reach(degree[2]);
  const Rational scale = negative_power(grading, level / 3);  // m^(-k/3), m^(-(k-1)/3), m^(-(k-2)/3)
  switch (level % 3) {
    case 0:
      return {scale * x, scale * y, scale * z};
    case 1:
      return {scale * x / grading, scale * y, scale * z};
    default:
      return {scale * x / grading, scale * y / grading, scale * z};
  }
}

Trial judge_radius(const RadiusOf& radius, const PerAxis<int>& degree, int grading, int level) {
  const ExactPoint radii = radius(degree, grading, level);
  const ExactPoint sides = sides_of_level(grading, level);
  Trial trial;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto a = at(axis);
    const Rational linear = sides[a] * reach(degree[a]);
    if (radii[a] != linear) {
      return {wrong_radius("D(k) is not size * (p + 3/2)", axis, degree[a], level, grading, radii[a], linear),
              trial.met};
    }
    if (grading == 2) continue;
    const Rational before = radius(degree, grading - 1, level)[a];
    const bool cut = sides[a] < 1;
    trial.met += cut;
    if (radii[a] > before || (cut && radii[a] == before)) {
      return {wrong_radius("D(k) does not decrease from grading m - 1 to m", axis, degree[a], level, grading, radii[a],
                           before),
              trial.met};
    }
  }
  return trial;
}

Trial judge_radii_on_mesh(const RefinementTree& tree, const Elements& elements, const RadiusOf& radius) {
  const PerAxis<int>& degree = tree.setting().degree;
  Trial trial;
  for (int level = 0; level <= tree.max_level(); ++level) {
    Trial one = judge_radius(radius, degree, tree.setting().grading + 1, level);  // against the mesh's own m
    if (one.verdict.outcome == Outcome::violated) return one;
  }
  for (const std::int32_t k : elements) {
    const int level = tree.node(k).level;
    trial.met += level > 0;
    if (auto verdict = wrong_environment(tree, k, radius(degree, tree.setting().grading, level))) {
      return {*verdict, trial.met};
    }
  }
  return trial;
}

Trial try_patch_shrinks(MeshUnderTest& mesh) {
  if (auto reason = outside_class(mesh)) return {*reason};
  return judge_radii_on_mesh(mesh.tree(), mesh.tree_elements(), radius_as_printed);
}

/// m from 2 to 20; p = 3, 5, 7, 9 with two axes that have other degrees; levels to 12, or to 60.
Trial try_patch_shrinks_alone(Extent extent) {
  const int last_level = extent == Extent::short_run ? 12 : 60;
  Trial trial;
  for (int p = 3; p <= 9; p += 2) {
    for (int grading = 2; grading <= 20; ++grading) {
      for (int level = 0; level <= last_level; ++level) {
        const Trial one = judge_radius(radius_as_printed, {p, 12 - p, p + 2}, grading, level);
        trial.met += one.met;
        if (one.verdict.outcome != Outcome::holds) return {one.verdict, trial.met};
      }
    }
  }
  return trial;
}

}  // namespace asts
