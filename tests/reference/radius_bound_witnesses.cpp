#include <algorithm>

#include "tests/reference/equation_checks.hpp"
#include "tests/reference/equation_claims.hpp"
#include "tests/reference/root_text.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

/// One level's bounds: a mesh's own m, degrees and levels, or any.
struct LevelOf {
  Setting setting;
  int level;

  LevelOf(ClaimSubject& subject, const json& values) : setting(subject.setting()) {
    const std::size_t m = read_count(values["m"], "m"), k = read_count(values["k"], "k");
    if (m < 2 || m > 1'000'000 || k > 10'000) throw Rejected("m is none of the paper's gradings, or k is above 10000");
    level = static_cast<int>(k);
    if (values.contains("degrees")) setting.degree = read_degrees(subject, values["degrees"]);
    if (subject.is_none()) {
      setting.grading = static_cast<int>(m);
      return;
    }
    require_equal(m, static_cast<std::size_t>(setting.grading), "m");
    require_admissible(setting, subject.mesh());
    int highest = 0;
    for (const Box& box : subject.mesh()) highest = std::max(highest, reference::level(setting, box).value());
    if (level > highest) throw Rejected("the mesh has no element of level k");
  }

  /// The axis's value above factor m^(-k/3).
  std::string compared(const json& values, const Point& actual, RootSum (*factor)(const Setting&, int)) const {
    const std::size_t axis = read_axis(values["axis"]);
    require_equal(read_point(values["value"]), actual, "the value");
    const RootSum bound = root_power(setting.grading, -level) * factor(setting, static_cast<int>(axis));
    require_equal(read_root_sum(values["bound along the axis"], setting.grading, "the bound"), bound, "the bound");
    if (sign(bound - RootSum{setting.grading, actual[axis]}) >= 0)
      throw Rejected("the bound holds: " + text(actual[axis]) + " <= " + text(bound));
    return "Along " + std::string(axis_name(axis)) + ", for m = " + std::to_string(setting.grading) + " and level " +
           std::to_string(level) + ": " + text(actual[axis]) + " > " + text(bound) + ".";
  }
};

RootSum p_tilde_and_s(const Setting& setting, int axis) { return p_tilde(setting, axis) + half_size(setting, axis); }

RootSum size_factor(const Setting& setting, int axis) { return root_power(setting.grading, axis); }

}  // namespace

std::string check_radius_bound(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"m", "degrees", "k", "axis", "value", "bound along the axis"});
  const LevelOf at(subject, values);
  return "D(k). " + at.compared(values, environment_radius(at.setting, at.level), p_tilde);
}

std::string check_size_bound(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"m", "degrees", "k", "axis", "value", "bound along the axis"});
  const LevelOf at(subject, values);
  return "size(k). " + at.compared(values, printed_size(at.setting, at.level), size_factor);
}

std::string check_size_grows(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"m", "k", "size(k)", "size(k - 1)"});
  const LevelOf at(subject, values);
  if (at.level == 0) throw Rejected("there is no level before 0");
  const Point own = printed_size(at.setting, at.level), before = printed_size(at.setting, at.level - 1);
  require_equal(read_point(values["size(k)"]), own, "size(k)");
  require_equal(read_point(values["size(k - 1)"]), before, "size(k - 1)");
  for (std::size_t a = 0; a < dimension; ++a)
    if (own[a] > before[a]) return "size(k) = " + text(own) + " exceeds size(k - 1) = " + text(before) + ".";
  throw Rejected("size(k) = " + text(own) + " is at most size(k - 1) = " + text(before) + " along each axis");
}

std::string check_patch_distance(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"m", "degrees", "k", "axis", "value", "bound along the axis", "K~", "K~'"});
  const LevelOf at(subject, values);
  const Setting& setting = at.setting;
  const Box k = element_of_mesh(setting, subject.mesh(), values["K~"], "K~").box;
  const Box other = element_of_mesh(setting, subject.mesh(), values["K~'"], "K~'").box;
  require_equal(static_cast<std::size_t>(level(setting, k).value()), static_cast<std::size_t>(at.level), "level(K~)");
  if (!closed_meets_open(other, environment(setting, k))) throw Rejected("K~' is not in the patch of K~");
  const std::size_t axis = read_axis(values["axis"]);
  Point along{0, 0, 0};
  along[axis] = distance(k, midpoint(other))[axis];
  return "The mesh is admissible; K~' = " + text(other) + " is in the patch of K~ = " + described(setting, k) + ". " +
         at.compared(values, along, p_tilde_and_s);
}

}  // namespace asts::reference
