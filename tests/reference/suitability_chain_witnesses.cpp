#include "tests/reference/spline_hypotheses.hpp"
#include "tests/reference/suitability_kinds.hpp"
#include "tests/reference/validate_kinds.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

using Hypothesis = std::string (*)(const Setting&, const Mesh&);
using Conclusion = std::string (*)(const Setting&, const Mesh&, const json&);

/// An implication is violated where its hypothesis holds and its conclusion fails.
std::string implication(ClaimSubject& subject, const json& witness, Hypothesis hypothesis, Conclusion conclusion) {
  const std::string holds = hypothesis(subject.setting(), subject.mesh());
  return "Hypothesis:" + holds + " Conclusion: " + conclusion(subject.setting(), subject.mesh(), witness);
}

}  // namespace

std::string check_as_implies_dc(ClaimSubject& subject, const json& witness) {
  return implication(subject, witness, mesh_is_suitable, validate_no_partial_overlap);
}

std::string check_as_implies_dc_repaired(ClaimSubject& subject, const json& witness) {
  return implication(subject, witness, suitable_in_whole_domain, validate_no_partial_overlap);
}

std::string check_dc_implies_as(ClaimSubject& subject, const json& witness) {
  return implication(subject, witness, mesh_is_compatible, validate_perturbed_regions_meet);
}

std::string check_dc_implies_as_repaired(ClaimSubject& subject, const json& witness) {
  return implication(subject, witness, touching_pairs_overlap, validate_perturbed_regions_meet);
}

std::string check_dc_implies_dual_basis(ClaimSubject& subject, const json& witness) {
  return implication(subject, witness, mesh_is_compatible, validate_lambda_not_delta);
}

std::string check_as_implies_dual_basis(ClaimSubject& subject, const json& witness) {
  return implication(subject, witness, mesh_is_suitable, validate_lambda_not_delta);
}

std::string check_as_implies_dual_basis_repaired(ClaimSubject& subject, const json& witness) {
  return implication(subject, witness, suitable_in_whole_domain, validate_lambda_not_delta);
}

namespace {

/// One of the two perturbed regions, with slices of space.active; its axis.
std::size_t check_region(const Space<Rational>& space, const Point& t, const json& value, const std::string& what,
                         std::string& report) {
  require_keys(value, {"axis", "slice", "in", "out"}, what);
  const std::size_t axis = read_axis(value["axis"]);
  if (read_number(value["slice"]) != t[axis]) throw Rejected(what + ": the point is not in the slice");
  report += in_slice_perturbation(space, axis, t, checked_active_node(space, value["in"], what + ": in"),
                                  checked_active_node(space, value["out"], what + ": out"));
  return axis;
}

}  // namespace

std::string check_admissible_not_suitable(ClaimSubject& subject, const json& witness) {
  require_keys(witness, {"kind", "point", "first", "second"}, "the witness");
  std::string report = "Hypothesis:" + mesh_is_admissible(subject.setting(), subject.mesh());
  report += splines_exist(subject.setting(), subject.mesh()) + " Conclusion, with slices of the closed domain:";
  // nodes are active by the active region, slices are those of the domain
  const Space<Rational> active = make_space<Rational>(subject.setting(), subject.mesh(), 1);
  const Space<Rational> whole = with_whole_domain(active);
  const Point t = read_point(witness["point"]);
  std::size_t axes[2];
  std::size_t number = 0;
  for (const char* what : {"first", "second"}) {
    const json& value = witness[what];
    require_keys(value, {"axis", "slice", "in", "out"}, what);
    for (const char* node : {"in", "out"}) checked_active_node(active, value[node], std::string(what) + ": " + node);
    axes[number++] = check_region(whole, t, value, what, report);
  }
  if (axes[0] == axes[1]) throw Rejected("both perturbed regions are of the same axis");
  return report + " Two of them meet: the mesh is not analysis-suitable in this sense.";
}

std::string check_overlapping_all_the_same(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"axis", "slice", "v1", "v2"});
  const std::string exist = splines_exist(subject.setting(), subject.mesh());
  const Space<Rational> space = make_space<Rational>(subject.setting(), subject.mesh(), 1);
  const std::size_t axis = read_axis(values["axis"]);
  const Rational q = read_number(values["slice"]);
  const ActiveNode<Rational> v1 = checked_active_node(space, values["v1"], "v1");
  const ActiveNode<Rational> v2 = checked_active_node(space, values["v2"], "v2");
  BasicBox<Rational> slice = space.active;
  if (q < slice.lower[axis] || slice.upper[axis] < q) throw Rejected("the slice does not meet the active region");
  slice.lower[axis] = slice.upper[axis] = q;
  const auto part = closed_intersection(slice, v1.support);
  if (!part || !closed_intersection(*part, v2.support))
    throw Rejected("the slice and both supports have no common point");
  const std::string name = slice_name(axis, q);
  if (!in_slice_nodes(space, axis, q, v1.node)) throw Rejected("v1 is not in " + name);
  if (in_slice_nodes(space, axis, q, v2.node)) throw Rejected("v2 is in " + name);
  if (!overlap(v1.vectors[axis], v2.vectors[axis]))
    throw Rejected("nothing is violated: " + described_vector(v1, axis) + " and " + described_vector(v2, axis) +
                   " do not overlap");
  return "Hypothesis:" + exist + " The slice at " + text(q) + " and the supports of v1 = " + described_node(v1) +
         " and v2 = " + described_node(v2) + " have a common point; v1 is in " + name +
         ", v2 is not. Conclusion: " + described_vector(v1, axis) + " and " + described_vector(v2, axis) +
         " overlap, by (6.1), against Lemma 6.5.";
}

}  // namespace asts::reference
