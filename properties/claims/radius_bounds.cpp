#include "properties/claims/radius_bounds.hpp"

#include <map>

#include "lib/mesh/level_formulas.hpp"
#include "properties/claims/family_equations.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

/// The largest distance along one axis from an element of one level to one of its patch.
struct Farthest {
  Rational distance = -1;
  std::size_t from = 0;
  std::size_t to = 0;
};

using ByLevel = std::map<std::int32_t, PerAxis<Farthest>>;

/// The bound depends on the level alone, so each level's largest distance decides, axis by axis.
ByLevel farthest_in_patches(const LeafPatches& patches, std::int64_t& met) {
  ByLevel result;
  for (std::size_t from = 0; from < patches.size(); ++from) {
    PerAxis<Farthest>& farthest = result[patches.level(from)];
    for (std::size_t to = 0; to < patches.size(); ++to) {
      if (from == to || !patches.in_patch(from, to)) continue;
      ++met;
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        const Rational distance = abs(Rational(patches.midpoint(from)[axis] - patches.midpoint(to)[axis]));
        if (distance > farthest[axis].distance) farthest[axis] = {distance, from, to};
      }
    }
  }
  return result;
}

std::optional<ClaimWitness> compare(const Setting& setting, int level, const char* kind, const PerAxis<Rational>& value,
                                    const PerAxis<CubeRootNumber>& factor) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const CubeRootNumber bound = factor[at(axis)] * cube_root_power(setting.grading, -level);
    if (bound >= value[at(axis)]) continue;
    ClaimWitness witness{kind, "a coordinate exceeds its bound", {}};
    witness.values = {{"m", std::int64_t{setting.grading}},
                      {"degrees", to_point(setting.degree)},
                      {"k", std::int64_t{level}},
                      {"axis", std::string(axis_name(axis))},
                      {"value", value},
                      {"bound along the axis", shown(bound)}};
    return witness;
  }
  return std::nullopt;
}

/// (f_1, t f_2, t^2 f_3), t = m^(1/3).
PerAxis<CubeRootNumber> times_root_powers(int grading, const PerAxis<Rational>& factor) {
  return {cube_root_power(grading, 0) * factor[0], cube_root_power(grading, 1) * factor[1],
          cube_root_power(grading, 2) * factor[2]};
}

PerAxis<CubeRootNumber> radius_factor(const Setting& setting) {
  PerAxis<Rational> factor;
  for (std::size_t axis = 0; axis < kDimension; ++axis) factor[axis] = setting.degree[axis] + Rational(3) / 2;
  return times_root_powers(setting.grading, factor);
}

}  // namespace

std::optional<ClaimWitness> judge_level_bounds(const Setting& setting, int level) {
  const int m = setting.grading;
  const PerAxis<Rational> size = level_size(m, level);
  if (auto witness =
          compare(setting, level, "radius-unbounded", level_radius(setting.degree, m, level), radius_factor(setting))) {
    return witness;
  }
  if (auto witness = compare(setting, level, "size-unbounded", size, times_root_powers(m, {1, 1, 1}))) return witness;
  if (level == 0) return std::nullopt;
  const PerAxis<Rational> before = level_size(m, level - 1);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (size[axis] <= before[axis]) continue;
    ClaimWitness witness{"size-grows", "size(k) exceeds size(k - 1)", {}};
    witness.values = {{"m", std::int64_t{m}}, {"k", std::int64_t{level}}, {"size(k)", size}, {"size(k - 1)", before}};
    return witness;
  }
  return std::nullopt;
}

PerAxis<CubeRootNumber> patch_distance_factor(const Setting& setting) {
  PerAxis<CubeRootNumber> factor = radius_factor(setting);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    factor[at(axis)] += cube_root_power(setting.grading, axis + 1) * (Rational(1) / 2);  // s
  }
  return factor;
}

std::optional<ClaimWitness> judge_patch_distances(const RefinementTree& tree, const LeafPatches& patches,
                                                  const PerAxis<CubeRootNumber>& factor, std::int64_t& met) {
  for (const auto& [level, farthest] : farthest_in_patches(patches, met)) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      PerAxis<Rational> value{0, 0, 0};
      value[axis] = farthest[axis].distance;
      auto witness = compare(tree.setting(), level, "patch-distance", value, factor);
      if (!witness) continue;
      witness->values.emplace_back("K~", describe_tree_element(tree, patches.node(farthest[axis].from)));
      witness->values.emplace_back("K~'", describe_tree_element(tree, patches.node(farthest[axis].to)));
      return witness;
    }
  }
  return std::nullopt;
}

Trial radius_bounds_on_mesh(MeshUnderTest& mesh) {
  if (!mesh.admissible()) return {Verdict::not_applicable("the mesh is not admissible")};
  const Setting& setting = mesh.tree().setting();
  Trial trial;
  std::optional<ClaimWitness> witness;
  for (int level = 0; level <= mesh.tree().max_level() && !witness; ++level) {
    witness = judge_level_bounds(setting, level);
  }
  if (!witness) {
    witness = judge_patch_distances(mesh.tree(), LeafPatches(mesh), patch_distance_factor(setting), trial.met);
  }
  if (witness) trial.verdict = Verdict::violated(std::move(*witness));
  return trial;
}

/// "for all k": levels 0 to 12, every m from 2 to 20, degrees that differ along the axes.
Trial radius_bounds_alone(Extent) {
  Trial trial;
  for (int m = 2; m <= 20; ++m) {
    for (int level = 0; level <= 12; ++level) {
      for (const PerAxis<int>& degree : {PerAxis<int>{3, 3, 3}, {3, 5, 9}, {9, 7, 3}}) {
        ++trial.met;
        if (auto witness = judge_level_bounds({degree, m, {1, 1, 1}}, level)) {
          return {Verdict::violated(std::move(*witness)), trial.met};
        }
      }
    }
  }
  return trial;
}

}  // namespace asts
