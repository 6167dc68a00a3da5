#include "tests/reference/refine.hpp"
#include "tests/reference/spline_hypotheses.hpp"
#include "tests/reference/theorem_5_3_kinds.hpp"
#include "tests/reference/validate_kinds.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

/// A point of a slice's claim: in the slice at xi, and not in Sigma.
struct PointOutsideSigma {
  Grid xi;
  PointIn<Grid> t;
};

PointOutsideSigma read_outside_sigma(const Step& step, const json& values) {
  const PointOutsideSigma result{read_xi(step, values["xi"]), read_units_point(step, values["point"])};
  if (result.t[step.x] != result.xi) throw Rejected("the point is not in the slice at xi");
  if (any_contains(cut_supports(step, result.xi, step.created), result.t)) throw Rejected("the point is in Sigma");
  return result;
}

}  // namespace

std::string check_larger_sigma(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"element", "xi", "point"});
  const auto [step, after, hypotheses] = read_step(subject, values["element"]);
  const auto [xi, t] = read_outside_sigma(step, values);
  const Nodes others = minus(projected_nodes(step), slice_nodes(step, step.before, xi));
  if (!any_contains(cut_supports(step, xi, others), t))
    throw Rejected("the point is in the support of no old node of P that is not in the slice's nodes before the step");
  return hypotheses + " Conclusion: " + text(read_point(values["point"])) +
         " is in the slice and in the support of a node of P, but not in Sigma.";
}

std::string check_outside_old_region(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"element", "xi", "point"});
  const auto [step, after, hypotheses] = read_step(subject, values["element"]);
  const auto [xi, t] = read_outside_sigma(step, values);
  if (any_contains(slice_region(step.before, step.x, xi), t))
    throw Rejected("the point is in the slice perturbation before the step");
  if (!any_contains(slice_region(step.after, step.x, xi), t))
    throw Rejected("the point is not in the slice perturbation after the step");
  return hypotheses + " Conclusion: " + text(read_point(values["point"])) + " is in R^_" + axis_name(step.x) + "(" +
         text(read_number(values["xi"])) + "), not in the slice perturbation before the step, and not in Sigma.";
}

namespace {

/// Is the element at a position in the patch of the other one (Definition 2.4)?
bool in_patch(const Setting& setting, const Mesh& mesh, std::size_t element, std::size_t of) {
  return closed_meets_open(mesh[element], environment(setting, mesh[of]));
}

/// Admissible, and analysis-suitable: a mesh without active nodes is, since it has no perturbed regions.
std::string patch_hypotheses(const Setting& setting, const Mesh& mesh, std::size_t k) {
  std::string hypotheses = "Hypotheses:" + mesh_is_admissible(setting, mesh);
  if (!active_nodes(make_space<Rational>(setting, mesh, 1)).empty()) hypotheses += mesh_is_suitable(setting, mesh);
  if (!admissible_subdivision(setting, mesh, k)) throw Rejected("the subdivision of the element is not admissible");
  return hypotheses + " The subdivision of K = " + text(mesh[k]) + " is admissible.";
}

}  // namespace

std::string check_second_patch(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"axis", "element", "through", "larger"});
  const Setting& setting = subject.setting();
  const Mesh& mesh = subject.mesh();
  const std::size_t axis = read_axis(values["axis"]);
  const std::size_t k = position_of_element(setting, mesh, values["element"], "element");
  const std::size_t inner = position_of_element(setting, mesh, values["through"], "through");
  const std::size_t larger = position_of_element(setting, mesh, values["larger"], "larger");
  const std::string hypotheses = patch_hypotheses(setting, mesh, k);
  const auto x = static_cast<std::size_t>(level(setting, mesh[k]).value() % 3);
  if (axis != x && axis != (x + 1) % 3) throw Rejected("nothing is said of the size along this axis");
  if (!in_patch(setting, mesh, inner, k)) throw Rejected("through: it is not in the patch of the element");
  if (!in_patch(setting, mesh, larger, inner)) throw Rejected("larger: it is not in the patch of \"through\"");
  const Rational size = mesh[k].upper[axis] - mesh[k].lower[axis];
  const Rational other = mesh[larger].upper[axis] - mesh[larger].lower[axis];
  if (other <= size) throw Rejected("nothing is violated: the sizes are " + text(size) + " and " + text(other));
  return hypotheses + " Conclusion: " + text(mesh[larger]) + " is in the patch of " + text(mesh[inner]) +
         ", which is in the patch of K; along " + axis_name(axis) + " its size is " + text(other) + " > " + text(size) +
         ", that of K.";
}

namespace {

/// [centre - eps factor, centre + eps factor], eps being half of K's size along the axis.
struct Reach {
  Grid lower, upper;
  bool contains(Grid value) const { return lower <= value && value <= upper; }
};

Reach reach(const Step& step, std::size_t axis, Grid centre, int factor) {
  const Grid radius = (step.k.upper[axis] - step.k.lower[axis]) / 2 * factor;
  return {centre - radius, centre + radius};
}

Grid middle(const Step& step, std::size_t axis) { return (step.k.lower[axis] + step.k.upper[axis]) / 2; }

std::string reach_text(const Step& step, const Reach& reach) {
  return "[" + text(Rational(Rational(reach.lower) / step.scale)) + ", " +
         text(Rational(Rational(reach.upper) / step.scale)) + "]";
}

}  // namespace

std::string check_sigma_too_large(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"element", "xi", "part"});
  const auto [step, after, hypotheses] = read_step(subject, values["element"]);
  const Grid xi = read_xi(step, values["xi"]);
  const Box box = read_box(values["part"], "part");
  const BasicBox<Grid> part{read_units_point(step, values["part"]["lower"]),
                            read_units_point(step, values["part"]["upper"])};
  for (std::size_t a = 0; a < dimension; ++a)
    if (part.upper[a] < part.lower[a]) throw Rejected("part is empty");
  if (!subset({part}, cut_supports(step, xi, step.created))) throw Rejected("part: it is no part of Sigma");
  std::string leaves;
  for (const std::size_t a : {step.y, step.z}) {
    const Reach allowed = reach(step, a, middle(step, a), step.setting.degree[a] + 2);
    if (allowed.contains(part.lower[a]) && allowed.contains(part.upper[a])) continue;
    leaves += std::string(" Along ") + axis_name(a) + " [" + text(box.lower[a]) + ", " + text(box.upper[a]) +
              "] leaves " + reach_text(step, allowed) + ".";
  }
  if (leaves.empty()) throw Rejected("nothing is violated: the part lies in the box that is said to contain Sigma");
  return hypotheses + " Conclusion: " + text(box) + " is a part of Sigma." + leaves;
}

std::string check_node_too_far(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"element", "xi", "node"});
  const auto [step, after, hypotheses] = read_step(subject, values["element"]);
  const Grid xi = read_xi(step, values["xi"]);
  const ActiveNode<Rational> node = checked_active_node(after, values["node"], "node");
  const BasicBox<Grid> support{read_units_point(step, values["node"]["support"]["lower"]),
                               read_units_point(step, values["node"]["support"]["upper"])};
  bool meets = false;
  for (const BasicBox<Grid>& part : cut_supports(step, xi, step.created))
    meets = meets || closed_intersection(part, support).has_value();
  if (!meets) throw Rejected("the node's support does not meet Sigma");
  const std::array<int, dimension>& p = step.setting.degree;
  const Reach allowed[] = {reach(step, step.x, xi, p[step.x] + 1),
                           reach(step, step.y, middle(step, step.y), 2 * p[step.y] + 3)};
  const std::size_t axes[] = {step.x, step.y};
  const PointIn<Grid> place = read_units_point(step, values["node"]["node"]);
  std::string leaves;
  for (std::size_t i = 0; i < 2; ++i)
    if (!allowed[i].contains(place[axes[i]]))
      leaves += std::string(" Along ") + axis_name(axes[i]) + " " + text(node.node[axes[i]]) + " is not in " +
                reach_text(step, allowed[i]) + ".";
  if (leaves.empty()) throw Rejected("nothing is violated: the node lies in the box that is said to contain it");
  return hypotheses + " Conclusion: the support of " + described_node(node) + " meets Sigma." + leaves;
}

}  // namespace asts::reference
