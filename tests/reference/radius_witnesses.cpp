#include <algorithm>

#include "tests/reference/refinement_checks.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

/// D(l(K)) along one axis, both sides of the comparison, and the value that U(K) must have there.
std::string check_end(ClaimSubject& subject, const json& witness, bool upper) {
  const Setting& setting = subject.setting();
  const json& values = values_of(witness, {"K", "axis", "value", "compared with"});
  require_class(setting, subject.mesh());
  const RefinementTree tree = refinement_tree(setting, subject.mesh());
  const TreeElement k = element_of_tree(setting, tree, values["K"], "K");
  const std::size_t axis = read_axis(values["axis"]);
  const Rational radius = environment_radius(setting, k.level)[axis];
  const Rational end = upper ? Rational(midpoint(k.box)[axis] + radius) : Rational(midpoint(k.box)[axis] - radius);
  const Rational clipped = upper ? std::min(end, Rational(setting.domain[axis])) : std::max(end, Rational(0));
  const Rational actual = (upper ? k.environment.upper : k.environment.lower)[axis];
  require_equal(read_number(values["compared with"]), clipped,
                "the midpoint with D(l(K)), cut off at the domain's end,");
  require_equal(read_number(values["value"]), actual, "the end of U(K)");
  if (actual == clipped) throw Rejected("both sides are " + text(actual));
  return "U(K) of K = " + text(k.box) + " ends at " + text(actual) + ", and not at " + text(clipped) + ".";
}

/// The numbers of a witness about D(k).
struct Radius {
  std::size_t axis;
  int degree, level, grading;
  Rational value, compared;

  explicit Radius(const json& witness) {
    const json& values =
        values_of(witness, {"axis", "degree along the axis", "level", "grading", "value", "compared with"});
    axis = read_axis(values["axis"]);
    degree = small(values["degree along the axis"], "degree along the axis");
    level = small(values["level"], "level");
    grading = small(values["grading"], "grading");
    if (degree < 3 || degree % 2 == 0 || grading < 2) throw Rejected("degree or grading is none of the paper's");
    value = read_number(values["value"]);
    compared = read_number(values["compared with"]);
    require_equal(value, of_grading(grading), "D(k) along the axis");
  }

  static int small(const json& value, const std::string& what) {
    const std::size_t count = read_count(value, what);
    if (count > 1'000'001) throw Rejected(what + " is too large");
    return static_cast<int>(count);
  }

  Rational of_grading(int m) const { return environment_radius({{degree, degree, degree}, m, {1, 1, 1}}, level)[axis]; }

  /// The side of an element of this level, by Definition 2.6.
  Rational side() const {
    const Setting setting{{degree, degree, degree}, grading, {1, 1, 1}};
    Box box = initial_mesh(setting).front();
    for (int k = 0; k < level; ++k) box = subdivide_along(setting, box, static_cast<std::size_t>(k % 3)).front();
    return box.upper[axis] - box.lower[axis];
  }
};

/// A witness that a mesh is given with must be about its degrees, levels and grading (against the next one).
void require_of_mesh(ClaimSubject& subject, const Radius& radius, bool next_grading) {
  if (subject.is_none()) return;
  const Setting& setting = subject.setting();
  int highest = 0;
  for (const Box& box : subject.mesh()) highest = std::max(highest, level(setting, box).value_or(0));
  const bool own = radius.grading == setting.grading || (next_grading && radius.grading == setting.grading + 1);
  if (!own || radius.degree != setting.degree[radius.axis] || radius.level > highest)
    throw Rejected("the degree, the level or the grading is not the mesh's");
}

}  // namespace

std::string check_environment_lower(ClaimSubject& subject, const json& witness) {
  return check_end(subject, witness, false);
}

std::string check_environment_upper(ClaimSubject& subject, const json& witness) {
  return check_end(subject, witness, true);
}

std::string check_radius_not_linear(ClaimSubject& subject, const json& witness) {
  const Radius radius(witness);
  require_of_mesh(subject, radius, true);
  const Rational linear = radius.side() * (radius.degree + Rational(3) / 2);
  require_equal(radius.compared, linear, "the size times p + 3/2");
  if (radius.value == linear) throw Rejected("D(k) is the size times p + 3/2: both are " + text(linear));
  return "D(k) = " + text(radius.value) + ", and the size times p + 3/2 = " + text(linear) + ".";
}

std::string check_radius_not_decreasing(ClaimSubject& subject, const json& witness) {
  const Radius radius(witness);
  require_of_mesh(subject, radius, true);
  if (radius.grading < 3) throw Rejected("the grading m - 1 is less than 2");
  const Rational before = radius.of_grading(radius.grading - 1);
  require_equal(radius.compared, before, "D(k) for the grading m - 1");
  const bool cut = radius.side() < 1;
  if (radius.value < before || (!cut && radius.value == before))
    throw Rejected("D(k) = " + text(radius.value) + (cut ? " < " : " <= ") + text(before) + " for the grading m - 1");
  return "D(k) = " + text(radius.value) + ", and " + text(before) + " for the grading m - 1.";
}

}  // namespace asts::reference
