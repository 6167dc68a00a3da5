#include <algorithm>

#include "tests/reference/refine.hpp"
#include "tests/reference/spline_hypotheses.hpp"
#include "tests/reference/theorem_5_3_kinds.hpp"
#include "tests/reference/validate_kinds.hpp"

namespace asts::reference {

using nlohmann::json;

StepSubject read_step(ClaimSubject& subject, const json& element) {
  const Setting& setting = subject.setting();
  const Mesh& mesh = subject.mesh();
  const std::size_t k = position_of_element(setting, mesh, element, "element");
  std::string hypotheses = "Hypotheses:" + mesh_is_admissible(setting, mesh);
  hypotheses += mesh_is_suitable(setting, mesh);
  if (!admissible_subdivision(setting, mesh, k)) throw Rejected("the subdivision of the element is not admissible");
  const Mesh refined = subdivide(setting, mesh, {k});
  if (!grid_scale(setting, refined)) throw Rejected("the mesh's denominators are too large for this check");
  Step step = make_step(setting, mesh, k);
  hypotheses += " K = " + text(mesh[k]) + " is subdivided along " + axis_name(step.x) + ", admissibly.";
  return {std::move(step), make_space<Rational>(setting, refined, 1), hypotheses};
}

Grid read_units(const Step& step, const json& number) {
  const Rational value = read_number(number);
  if (denominator(Rational(value * step.scale)) != 1 || value < 0 ||
      value > *std::max_element(step.setting.domain.begin(), step.setting.domain.end()))
    throw Rejected(text(value) + " is no coordinate of the mesh, nor halfway between two of them");
  return on_grid(value, step.scale);
}

PointIn<Grid> read_units_point(const Step& step, const json& point) {
  read_point(point);
  return {read_units(step, point[0]), read_units(step, point[1]), read_units(step, point[2])};
}

Grid read_xi(const Step& step, const json& number) {
  const Grid xi = read_units(step, number);
  if (std::find(step.xi.begin(), step.xi.end(), xi) == step.xi.end())
    throw Rejected("xi: " + text(read_number(number)) + " is no coordinate of a new face");
  return xi;
}

std::string check_admissible_implies_as(ClaimSubject& subject, const json& witness) {
  const std::string holds = mesh_is_admissible(subject.setting(), subject.mesh());
  return "Hypothesis:" + holds +
         " Conclusion: " + validate_perturbed_regions_meet(subject.setting(), subject.mesh(), witness);
}

namespace {

bool perturbed(const Side& side, std::size_t axis, const PointIn<Grid>& t) {
  return in_perturbed_region(side.space, side.splines, axis, t);
}

const char* is_or_not(bool is) { return is ? " is " : " is not "; }

}  // namespace

std::string check_region_changed(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"element", "axis", "point", "in"});
  const auto [step, after, hypotheses] = read_step(subject, values["element"]);
  const std::size_t axis = read_axis(values["axis"]);
  const PointIn<Grid> t = read_units_point(step, values["point"]);
  if (axis == step.x && std::find(step.xi.begin(), step.xi.end(), t[axis]) != step.xi.end())
    throw Rejected("the point is in one of the new slices, of which nothing is said");
  const bool before = perturbed(step.before, axis, t), afterwards = perturbed(step.after, axis, t);
  if (before == afterwards)
    throw Rejected(std::string("nothing is violated: the point") + is_or_not(before) + "in both regions");
  if (read_choice(values["in"], "before", "after", "in") != before) throw Rejected("the point is in the other region");
  return hypotheses + " Conclusion: " + text(read_point(values["point"])) + is_or_not(before) + "in R_" +
         axis_name(axis) + " before and" + is_or_not(afterwards) + "in it after the step.";
}

std::string check_sigma_meets_region(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"element", "xi", "axis", "point"});
  const auto [step, after, hypotheses] = read_step(subject, values["element"]);
  const Grid xi = read_xi(step, values["xi"]);
  const std::size_t axis = read_axis(values["axis"]);
  if (axis == step.x) throw Rejected("nothing is said of the region of the axis that K is subdivided along");
  const PointIn<Grid> t = read_units_point(step, values["point"]);
  if (t[step.x] != xi) throw Rejected("the point is not in the slice at xi");
  if (!any_contains(cut_supports(step, xi, step.created), t)) throw Rejected("the point is not in Sigma");
  if (!perturbed(step.after, axis, t))
    throw Rejected(std::string("the point is not in the perturbed region of ") + axis_name(axis));
  return hypotheses + " Conclusion: " + text(read_point(values["point"])) +
         " is in Sigma, in the slice and the support of a new active node, and in R^_" + axis_name(axis) + ".";
}

namespace {

bool among(const Nodes& nodes, const PointIn<Grid>& v) {
  return std::find(nodes.begin(), nodes.end(), v) != nodes.end();
}

std::string check_split(ClaimSubject& subject, const json& witness, bool repaired) {
  const json& values = values_of(witness, {"element", "xi", "node", "new", "in_slice_before", "in_slice_after"});
  const auto [step, after, hypotheses] = read_step(subject, values["element"]);
  const Grid xi = read_xi(step, values["xi"]);
  const ActiveNode<Rational> node = checked_active_node(after, values["node"], "node");
  const PointIn<Grid> v = read_units_point(step, values["node"]["node"]);
  const bool is_new = among(step.created, v), before = among(slice_nodes(step, step.before, xi), v);
  const bool afterwards = among(slice_nodes(step, step.after, xi), v);
  const bool projected = among(projected_nodes(step), v);
  const auto expect = [&](const char* name, bool actual) {
    if (read_choice(values[name], "yes", "no", name) != actual)
      throw Rejected(std::string(name) + " is " + (actual ? "yes" : "no"));
  };
  expect("new", is_new);
  expect("in_slice_before", before);
  expect("in_slice_after", afterwards);
  const bool expected = before || is_new || (repaired && projected);
  if (expected == afterwards) throw Rejected("nothing is violated: the split says what is true of the node");
  const std::string name = slice_name(step.x, read_number(values["xi"]));
  return hypotheses + " Conclusion: the active node " + described_node(node) + is_or_not(before) + "in " + name +
         " before the step," + is_or_not(is_new) + "new," + is_or_not(projected) +
         "one of the old nodes whose projection is in the new face, and" + is_or_not(afterwards) + "in " + name +
         " after the step; the split says the opposite.";
}

}  // namespace

std::string check_new_node_split(ClaimSubject& subject, const json& witness) {
  return check_split(subject, witness, false);
}

std::string check_new_node_split_repaired(ClaimSubject& subject, const json& witness) {
  return check_split(subject, witness, true);
}

}  // namespace asts::reference
