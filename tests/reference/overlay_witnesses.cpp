#include <algorithm>

#include "tests/reference/corner_experiment.hpp"
#include "tests/reference/overlay.hpp"
#include "tests/reference/refinement_checks.hpp"
#include "tests/reference/validate_kinds.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

/// The mesh that has subdivided exactly these elements: those of lower levels come first.
Mesh subdivided_at(const Setting& setting, const std::vector<json>& elements, const std::string& what) {
  std::vector<ElementText> pending;
  for (const json& value : elements) {
    pending.push_back(read_element(value, what));
    check_level(setting, pending.back(), what);
  }
  std::stable_sort(pending.begin(), pending.end(),
                   [](const ElementText& a, const ElementText& b) { return a.level < b.level; });
  Mesh mesh = initial_mesh(setting);
  for (const ElementText& element : pending) {
    const auto position = static_cast<std::size_t>(std::find(mesh.begin(), mesh.end(), element.box) - mesh.begin());
    if (position == mesh.size()) throw Rejected(what + ": " + text(element.box) + " cannot be subdivided");
    mesh = subdivide(setting, mesh, {position});
  }
  return mesh;
}

Mesh in_order(Mesh mesh) {
  std::sort(mesh.begin(), mesh.end());
  return mesh;
}

/// G1, which is the mesh, G2, both admissible, and their overlay.
struct Overlay {
  Mesh one, other, both;

  Overlay(ClaimSubject& subject, const json& values) {
    const Setting& setting = subject.setting();
    one = subdivided_at(setting, numbered(values, "subdivided in G1"), "subdivided in G1");
    other = subdivided_at(setting, numbered(values, "subdivided in G2"), "subdivided in G2");
    if (in_order(one) != in_order(subject.mesh())) throw Rejected("the elements subdivided in G1 do not make the mesh");
    require_admissible(setting, one, "G1");
    require_admissible(setting, other, "G2");
    both = common_refinement(one, other);
  }
};

}  // namespace

std::string check_overlay_not_admissible(ClaimSubject& subject, const json& witness) {
  const json& values =
      values_with_lists(witness, {"element", "environment", "coarser"}, {"subdivided in G1", "subdivided in G2"});
  const Overlay overlay(subject, values);
  return "G1 and G2 are admissible. In their overlay: " +
         validate_coarser_in_patch(subject.setting(), overlay.both,
                                   {{"kind", "coarser-in-patch"},
                                    {"element", values["element"]},
                                    {"environment", values["environment"]},
                                    {"coarser", values["coarser"]}});
}

std::string check_overlay_too_large(ClaimSubject& subject, const json& witness) {
  const json& values =
      values_with_lists(witness, {"elements of G1 (+) G2", "elements of G0", "elements of G1", "elements of G2"},
                        {"subdivided in G1", "subdivided in G2"});
  const Overlay overlay(subject, values);
  const std::size_t initial = initial_mesh(subject.setting()).size();
  const auto require_count = [&](const char* name, std::size_t actual) {
    require_equal(read_count(values[name], name), actual, name);
  };
  require_count("elements of G1 (+) G2", overlay.both.size());
  require_count("elements of G0", initial);
  require_count("elements of G1", overlay.one.size());
  require_count("elements of G2", overlay.other.size());
  const std::size_t left = overlay.both.size() + initial, right = overlay.one.size() + overlay.other.size();
  if (left <= right) throw Rejected("the bound holds: " + std::to_string(left) + " <= " + std::to_string(right));
  return "G1 and G2 are admissible, and " + std::to_string(left) + " = elements(G1 (+) G2) + elements(G0) > " +
         "elements(G1) + elements(G2) = " + std::to_string(right) + ".";
}

namespace {

struct TableRow {
  int grading;
  std::size_t steps, new_elements;
};

constexpr TableRow printed_table[] = {{2, 12, 10728}, {4, 6, 3175}, {16, 3, 1030}};

/// The element at the origin after so many steps, which have all subdivided it.
Point corner_sides(const Setting& setting, std::size_t steps) {
  Box box = initial_mesh(setting).front();
  for (std::size_t k = 0; k < steps; ++k) box = subdivide_along(setting, box, k % 3).front();
  return box.upper;
}

bool small_enough(const Point& sides) {
  return std::all_of(sides.begin(), sides.end(), [](const Rational& side) { return side * 16 <= 1; });
}

/// The steps mark the element at the origin alone, until its sides are 1/16 or less.
bool is_example(const Setting& setting, const std::vector<LiteralStep>& steps) {
  const bool own = setting.degree == std::array{3, 3, 3} && setting.domain == std::array{4, 5, 8};
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const Point sides = corner_sides(setting, n);
    if (!own || !steps[n].refine || steps[n].marks.empty() || small_enough(sides)) return false;
    for (const Point& mark : steps[n].marks)
      for (std::size_t a = 0; a < dimension; ++a)
        if (mark[a] < 0 || mark[a] >= sides[a]) return false;
  }
  return own && small_enough(corner_sides(setting, steps.size()));
}

}  // namespace

std::string check_example_table(ClaimSubject& subject, const json& witness) {
  const json& values =
      values_of(witness, {"grading", "refinement steps", "printed steps", "new elements", "printed new elements"});
  const std::size_t grading = read_count(values["grading"], "grading");
  const auto row = std::find_if(std::begin(printed_table), std::end(printed_table),
                                [&](const TableRow& one) { return static_cast<std::size_t>(one.grading) == grading; });
  if (row == std::end(printed_table)) throw Rejected("the table has no row for this grading");
  const Setting setting{{3, 3, 3}, row->grading, {4, 5, 8}};
  if (!subject.is_none() && (subject.steps() == nullptr || subject.setting().grading != row->grading ||
                             !is_example(subject.setting(), *subject.steps())))
    throw Rejected("the steps are not the sequence of Example 2.10");
  std::size_t steps = 0;
  while (!small_enough(corner_sides(setting, steps))) ++steps;
  const auto found = static_cast<std::size_t>(corner_counts(setting, static_cast<int>(steps)).back());
  require_equal(read_count(values["printed steps"], "printed steps"), row->steps, "the printed number of steps");
  require_equal(read_count(values["printed new elements"], "printed new elements"), row->new_elements,
                "the printed number of new elements");
  require_equal(read_count(values["refinement steps"], "refinement steps"), steps, "the number of steps");
  require_equal(read_count(values["new elements"], "new elements"), found, "the number of new elements");
  if (steps == row->steps && found == row->new_elements)
    throw Rejected("the numbers are those of the table: " + std::to_string(steps) + " steps, " + std::to_string(found) +
                   " new elements");
  return "m = " + std::to_string(grading) + ": " + std::to_string(steps) + " steps and " + std::to_string(found) +
         " new elements, not the printed " + std::to_string(row->steps) + " and " + std::to_string(row->new_elements) +
         ".";
}

}  // namespace asts::reference
