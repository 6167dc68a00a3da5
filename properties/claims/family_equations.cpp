#include "properties/claims/family_equations.hpp"

#include "lib/mesh/level_formulas.hpp"

namespace asts {

namespace {

/// Both printed forms of the distance, "parent dist" by the parent's level and "child dist" by the child's. The
/// exponents are whole: l(K^) + 6, 5, 4 and l(K) + 5, 4, 3 are multiples of 3 where they are used.
ExactPoint printed_by_parent(int grading, int parent_level) {
  const int axis = parent_level % kDimension;
  ExactPoint result{0, 0, 0};
  result[at(axis)] = grading_power(grading, -(parent_level + 6 - axis) / 3);
  return result;
}

ExactPoint printed_by_child(int grading, int level) {
  const int axis = (level + 2) % kDimension;  // 0 for level 1, 1 for level 2, 2 for level 0 mod 3
  ExactPoint result{0, 0, 0};
  result[at(axis)] = grading_power(grading, -(level + 5 - axis) / 3);
  return result;
}

ClaimWitness witness_of(const ParentAndChild& family, std::string kind, std::string says) {
  ClaimWitness witness{std::move(kind), std::move(says), {}};
  witness.values = {{"m", std::int64_t{family.setting.grading}},
                    {"K^", family.parent},
                    {"K", family.child},
                    {"j", std::int64_t{family.number}}};
  return witness;
}

std::optional<ClaimWitness> compare(const ParentAndChild& family, const ExactPoint& expected, const char* expected_name,
                                    const char* says) {
  const ExactPoint actual = distance(family.child.box, family.parent.box);
  if (actual == expected) return std::nullopt;
  ClaimWitness witness = witness_of(family, "other-distance", says);
  witness.values.emplace_back("Dist(K,K^)", actual);
  witness.values.emplace_back(expected_name, expected);
  return witness;
}

/// factor * (m^-(l+5)/3, m^-(l+4)/3, m^-(l+3)/3) lifted by `lift`, l = l(K), against Dist(K^,K).
std::optional<ClaimWitness> compare_bound(const ParentAndChild& family, const Rational& factor, int lift) {
  const ExactPoint actual = distance(family.parent.box, family.child.box);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const CubeRootNumber bound = cube_root_power(family.setting.grading, -(*family.child.level + lift - axis)) * factor;
    if (bound >= actual[at(axis)]) continue;
    ClaimWitness witness = witness_of(family, "bound-exceeded", "a child is farther from its parent than the bound");
    witness.values.emplace_back("axis", std::string(axis_name(axis)));
    witness.values.emplace_back("Dist(K^,K)", actual);
    witness.values.emplace_back("bound along the axis", shown(bound));
    return witness;
  }
  return std::nullopt;
}

}  // namespace

std::string shown(const CubeRootNumber& number) {
  if (number.is_rational()) return to_string(number);
  const DecimalEnclosure decimal = enclose_decimal(number);
  return to_string(number) + ", between " + decimal.lower + " and " + decimal.upper;
}

std::optional<ClaimWitness> judge_size(const ParentAndChild& family) {
  const ExactPoint expected = level_size(family.setting.grading, *family.child.level);
  const ExactPoint actual = sides(family.child.box);
  if (actual == expected) return std::nullopt;
  ClaimWitness witness = witness_of(family, "other-size", "the sides of K are not size(l(K))");
  witness.values.emplace_back("sides", actual);
  witness.values.emplace_back("size(l(K))", expected);
  return witness;
}

std::optional<ClaimWitness> judge_child_distance(const ParentAndChild& family) {
  const int m = family.setting.grading;
  if (auto witness = compare(family, printed_by_parent(m, *family.parent.level), "printed, by l(K^)",
                             "Dist(K,K^) is not what the formula by the parent's level says")) {
    return witness;
  }
  return compare(family, printed_by_child(m, *family.child.level), "printed, by l(K)",
                 "Dist(K,K^) is not what the formula by the child's level says");
}

std::optional<ClaimWitness> judge_child_distance_repaired(const ParentAndChild& family) {
  const int m = family.setting.grading;
  const auto axis = at(*family.parent.level % kDimension);
  ExactPoint expected{0, 0, 0};
  const Rational side = level_size(m, *family.parent.level)[axis];
  expected[axis] = side * std::abs(2 * family.number - 1 - m) / (2 * m);
  return compare(family, expected, "|2j-1-m|/(2m) of the parent's side", "Dist(K,K^) is not the repaired formula's");
}

std::optional<ClaimWitness> judge_radius_step(const ParentAndChild& family) {
  const Setting& setting = family.setting;
  const ExactPoint step = distance(family.child.box, family.parent.box);
  const PerAxis<Rational> inner = level_radius(setting.degree, setting.grading, *family.child.level);
  const PerAxis<Rational> outer = level_radius(setting.degree, setting.grading, *family.child.level - 1);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (inner[axis] + step[axis] <= outer[axis]) continue;
    ClaimWitness witness = witness_of(family, "radius-step", "D(l(K)) + Dist(K,K^) exceeds D(l(K) - 1)");
    witness.values.emplace_back("degrees", to_point(setting.degree));
    witness.values.emplace_back("Dist(K,K^)", step);
    witness.values.emplace_back("D(l(K))", inner);
    witness.values.emplace_back("D(l(K) - 1)", outer);
    return witness;
  }
  return std::nullopt;
}

std::optional<ClaimWitness> judge_child_bound(const ParentAndChild& family) { return compare_bound(family, 1, 5); }

/// Dist(K^,K) is at most (m-1)/(2m) of K^'s side along the axis of the split and 0 along the others; that side is
/// m^-(l-1)/3, m^-(l-2)/3, m^-(l-3)/3 for l = l(K) = 1, 2, 0 mod 3, split along x, y, z; and (m-1)/(2m) of it is
/// (m-1)/2 times m^-(l+2)/3, m^-(l+1)/3, m^-l/3. Reached by the first and the last child.
std::optional<ClaimWitness> judge_child_bound_repaired(const ParentAndChild& family) {
  return compare_bound(family, Rational(family.setting.grading - 1) / 2, 2);
}

}  // namespace asts
