#include <algorithm>

#include "tests/reference/equation_checks.hpp"
#include "tests/reference/equation_claims.hpp"
#include "tests/reference/root_text.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {

using nlohmann::json;

std::array<int, dimension> read_degrees(const ClaimSubject& subject, const json& value) {
  const Point claimed = read_point(value);
  std::array<int, dimension> degree = subject.setting().degree;
  for (std::size_t a = 0; a < dimension; ++a) {
    if (!subject.is_none()) require_equal(claimed[a], Rational(degree[a]), "the degree along an axis");
    if (!subject.is_none()) continue;
    degree[a] = 3;
    while (Rational(degree[a]) < claimed[a] && degree[a] < 1000) degree[a] += 2;
    if (Rational(degree[a]) != claimed[a]) throw Rejected("degrees: not odd, or not from 3 to 1001");
  }
  return degree;
}

namespace {

/// K^ and its j-th child K, as the witness has them: elements of the mesh's tree, or of any unit cube's alone.
struct Family {
  Setting setting;
  Box parent, child;
  int parent_level, j;

  Family(ClaimSubject& subject, const json& values) : setting(subject.setting()) {
    const std::size_t m = read_count(values["m"], "m");
    if (subject.is_none()) {
      if (m < 2 || m > 1'000'000) throw Rejected("m is none of the paper's gradings");
      setting.grading = static_cast<int>(m);
    } else {
      require_equal(m, static_cast<std::size_t>(setting.grading), "m");
    }
    parent = read(subject, values["K^"], "K^");
    child = read(subject, values["K"], "K");
    parent_level = level(setting, parent).value();
    const std::size_t number = read_count(values["j"], "j");
    const std::vector<Box> all = children(setting, parent);
    if (number < 1 || number > all.size()) throw Rejected("j is not from 1 to m");
    if (!(all[number - 1] == child)) throw Rejected("child number j of K^ is " + text(all[number - 1]) + ", not K");
    j = static_cast<int>(number);
  }

  Box read(ClaimSubject& subject, const json& value, const std::string& what) const {
    if (!subject.is_none()) return element_of_tree(setting, refinement_tree(setting, subject.mesh()), value, what).box;
    const ElementText element = read_element(value, what);
    const Setting one_cube{setting.degree, setting.grading, {1, 1, 1}};
    if (!in_class(one_cube, element.box)) throw Rejected(what + ": subdivisions of [0,1]^3 do not make it");
    check_level(setting, element, what);
    return element.box;
  }

  Point distance_of_child() const { return distance(child, midpoint(parent)); }

  std::string sentence() const {
    return "m = " + std::to_string(setting.grading) + ". K = " + text(child) + " is child " + std::to_string(j) +
           " of K^ = " + described(setting, parent) + ". ";
  }
};

/// An equation between points that does not hold.
std::string check_equation(const Family& family, const json& values, const char* left_name, const Point& left,
                           const char* right_name, const Point& right) {
  require_equal(read_point(values[left_name]), left, left_name);
  require_equal(read_point(values[right_name]), right, right_name);
  if (left == right) throw Rejected("the equation holds: both sides are " + text(left));
  return family.sentence() + left_name + ": " + text(left) + ", " + right_name + ": " + text(right) + ".";
}

/// factor (m^-(l+lift)/3, m^-(l+lift-1)/3, m^-(l+lift-2)/3) with l = l(K).
std::string check_bound(ClaimSubject& subject, const json& witness, const Rational& factor_over_m_less_1, int lift) {
  const json& values = values_of(witness, {"m", "K^", "K", "j", "axis", "Dist(K^,K)", "bound along the axis"});
  const Family family(subject, values);
  const std::size_t axis = read_axis(values["axis"]);
  const int m = family.setting.grading;
  const Point actual = family.distance_of_child();
  require_equal(read_point(values["Dist(K^,K)"]), actual, "Dist(K^,K)");
  const Rational factor = factor_over_m_less_1 == 0 ? Rational(1) : Rational(factor_over_m_less_1 * (m - 1));
  const RootSum bound = root_power(m, -(family.parent_level + 1 + lift - static_cast<int>(axis))) * factor;
  require_equal(read_root_sum(values["bound along the axis"], m, "the bound"), bound, "the bound");
  if (sign(bound - RootSum{m, actual[axis]}) >= 0)
    throw Rejected("the bound holds: " + text(actual[axis]) + " <= " + text(bound));
  return family.sentence() + "Along " + axis_name(axis) + " their distance is " + text(actual[axis]) + ", more than " +
         text(bound) + ".";
}

}  // namespace

std::string check_size(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"m", "K^", "K", "j", "sides", "size(l(K))"});
  const Family family(subject, values);
  return check_equation(family, values, "sides", size(family.child), "size(l(K))",
                        printed_size(family.setting, family.parent_level + 1));
}

std::string check_distance_by_parent(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"m", "K^", "K", "j", "Dist(K,K^)", "printed, by l(K^)"});
  const Family family(subject, values);
  return check_equation(family, values, "Dist(K,K^)", family.distance_of_child(), "printed, by l(K^)",
                        printed_parent_distance(family.setting, family.parent_level));
}

std::string check_distance_by_child(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"m", "K^", "K", "j", "Dist(K,K^)", "printed, by l(K)"});
  const Family family(subject, values);
  return check_equation(family, values, "Dist(K,K^)", family.distance_of_child(), "printed, by l(K)",
                        printed_child_distance(family.setting, family.parent_level + 1));
}

std::string check_repaired_distance(ClaimSubject& subject, const json& witness) {
  const char* const name = "|2j-1-m|/(2m) of the parent's side";
  const json& values = values_of(witness, {"m", "K^", "K", "j", "Dist(K,K^)", name});
  const Family family(subject, values);
  const int m = family.setting.grading, steps = 2 * family.j - 1 - m;
  const auto axis = static_cast<std::size_t>(family.parent_level % 3);
  Point expected{0, 0, 0};
  expected[axis] = size(family.parent)[axis] * (steps < 0 ? -steps : steps) / (2 * m);
  return check_equation(family, values, "Dist(K,K^)", family.distance_of_child(), name, expected);
}

std::string check_radius_step(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"m", "K^", "K", "j", "degrees", "Dist(K,K^)", "D(l(K))", "D(l(K) - 1)"});
  Family family(subject, values);
  family.setting.degree = read_degrees(subject, values["degrees"]);
  const Point step = family.distance_of_child();
  const Point inner = environment_radius(family.setting, family.parent_level + 1);
  const Point outer = environment_radius(family.setting, family.parent_level);
  require_equal(read_point(values["Dist(K,K^)"]), step, "Dist(K,K^)");
  require_equal(read_point(values["D(l(K))"]), inner, "D(l(K))");
  require_equal(read_point(values["D(l(K) - 1)"]), outer, "D(l(K) - 1)");
  for (std::size_t a = 0; a < dimension; ++a)
    if (inner[a] + step[a] > outer[a])
      return family.sentence() + "Along " + axis_name(a) + ", " + text(inner[a]) + " + " + text(step[a]) + " > " +
             text(outer[a]) + ".";
  throw Rejected("D(l(K)) + Dist(K,K^) is at most D(l(K) - 1) = " + text(outer) + " along each axis");
}

std::string check_child_bound(ClaimSubject& subject, const json& witness) {
  return check_bound(subject, witness, 0, 5);
}

std::string check_repaired_child_bound(ClaimSubject& subject, const json& witness) {
  return check_bound(subject, witness, Rational(1) / 2, 2);
}

}  // namespace asts::reference
