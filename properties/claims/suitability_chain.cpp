#include "properties/claims/suitability_chain.hpp"

#include <algorithm>

#include "properties/describe.hpp"
#include "properties/properties.hpp"
#include "properties/splines_needed.hpp"

// Why the repaired forms hold.
//
// Write R'_x for the perturbed regions with slices S'_x(q) = {x = q} of the closed domain in place of the slices of AR,
// and DC' for: any two active nodes whose closed supports meet, if only in a point, partially overlap.
// Theorem: no two of R'_x, R'_y, R'_z meet if and only if DC'. Since DC' implies DC, and regions that do not meet imply
// that the smaller R_x, R_y, R_z do not, both repaired inclusions follow.
//
// "Regions do not meet => DC'", the paper's proof: let v, w have supports that meet in [x_m, x_M] x [y_m, y_M] x
// [z_m, z_M], not empty, and let overlap fail along x and y. Then some q in [x_m, x_M] is an entry of one of xx(v),
// xx(w) and not of the other, say of xx(v). So v is in N_x(q); w is not, because q is in the range of xx(w), which has
// all entries of X(w_2, w_3) there. So R'_x(q) contains S'_x(q) cut with both supports, which is {q} x [y_m, y_M] x
// [z_m, z_M]; likewise R'_y(r) contains [x_m, x_M] x {r} x [z_m, z_M]; (q, r, z_m) is in both. With slices of AR this
// fails when q or r lies outside of AR, where S_x(q) is empty: that is the printed proof's fault.
//
// "DC' => regions do not meet", the paper's five cases: a common point of R'_x(q) and R'_y(r) gives v_1, v_2, v_3, v_4;
// in each case Lemma 6.5 gives a pair of them whose vectors fail to overlap along x and y, and both supports contain
// the point. With DC the case needs a common volume. Along x and y there is one, since a coordinate that is missing
// from a vector is inside of its range; along z the supports may only touch: that is the printed proof's fault.
//
// A form that leaves DC as it is: DC holds if and only if no point (q, r, s) and nodes v_1, ..., v_4 as in the proof
// have s inside of all four supports' ranges along the third axis (slices of the closed domain), for each pair of axes.

namespace asts {

namespace {

Trial not_applicable(const char* reason) { return {Verdict::not_applicable(reason)}; }

/// What keeps an implication from being vacuous: pairs of groups of nodes for which overlap is not a matter of course.
Trial holds(MeshUnderTest& mesh) { return {Verdict::holds(), count_overlap_failures(mesh.bricks())}; }

std::int64_t regions_not_empty(const PerturbedRegions& regions) {
  return std::count_if(regions.begin(), regions.end(), [](const std::vector<Box>& region) { return !region.empty(); });
}

constexpr const char* kNotSuitable = "perturbed regions meet";
constexpr const char* kNotCompatible = "two active nodes do not partially overlap";

/// The conclusion "lambda_v(B_w) = delta_vw".
Trial conclude_dual_basis(MeshUnderTest& mesh) {
  if (mesh.dual_failures().one) return {decide_dual_basis(mesh)};
  return holds(mesh);
}

template <class Decide>
Trial with_splines(MeshUnderTest& mesh, const Decide& decide) {
  if (auto verdict = lacks_splines(mesh)) return {*verdict};
  return decide();
}

}  // namespace

Meeting find_meeting_in_whole_domain(MeshUnderTest& mesh) {
  return find_meeting(perturbed_regions(mesh.bricks(), whole_domain(mesh.mesh())));
}

Trial judge_as_implies_dc(MeshUnderTest& mesh, const Meeting& meeting) {
  if (meeting) return not_applicable(kNotSuitable);
  if (mesh.incompatible()) return {decide_dual_compatible(mesh)};
  return holds(mesh);
}

Trial judge_as_implies_dc_repaired(MeshUnderTest& mesh, const Meeting& meeting) {
  if (meeting && mesh.admissible()) return {Verdict::violated(describe_meeting(mesh, *meeting))};
  return judge_as_implies_dc(mesh, meeting);
}

Trial judge_dc_implies_as(MeshUnderTest& mesh, const Incompatible& incompatible) {
  if (incompatible) return not_applicable(kNotCompatible);
  if (mesh.meeting_regions()) return {decide_analysis_suitable(mesh)};
  return {Verdict::holds(), regions_not_empty(mesh.perturbed_regions())};
}

Trial judge_as_implies_dual_basis(MeshUnderTest& mesh, const Meeting& meeting) {
  return meeting ? not_applicable(kNotSuitable) : conclude_dual_basis(mesh);
}

Trial judge_dc_implies_dual_basis(MeshUnderTest& mesh, const Incompatible& incompatible) {
  return incompatible ? not_applicable(kNotCompatible) : conclude_dual_basis(mesh);
}

Trial as_implies_dc(MeshUnderTest& mesh) {
  return with_splines(mesh, [&] { return judge_as_implies_dc(mesh, mesh.meeting_regions()); });
}

Trial as_implies_dc_repaired(MeshUnderTest& mesh) {
  return with_splines(mesh, [&] { return judge_as_implies_dc_repaired(mesh, find_meeting_in_whole_domain(mesh)); });
}

Trial dc_implies_as(MeshUnderTest& mesh) {
  return with_splines(mesh, [&] { return judge_dc_implies_as(mesh, mesh.incompatible()); });
}

Trial dc_implies_as_repaired(MeshUnderTest& mesh) {
  return with_splines(
      mesh, [&] { return judge_dc_implies_as(mesh, find_incompatible_meeting(mesh.splines(), mesh.bricks())); });
}

Trial dc_implies_dual_basis(MeshUnderTest& mesh) {
  return with_splines(mesh, [&] { return judge_dc_implies_dual_basis(mesh, mesh.incompatible()); });
}

Trial as_implies_dual_basis(MeshUnderTest& mesh) {
  return with_splines(mesh, [&] { return judge_as_implies_dual_basis(mesh, mesh.meeting_regions()); });
}

Trial as_implies_dual_basis_repaired(MeshUnderTest& mesh) {
  return with_splines(mesh, [&] { return judge_as_implies_dual_basis(mesh, find_meeting_in_whole_domain(mesh)); });
}

}  // namespace asts
