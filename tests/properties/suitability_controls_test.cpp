#include <array>

#include "properties/claims/case_table.hpp"
#include "properties/claims/perturbed_overlap.hpp"
#include "properties/claims/suitability_chain.hpp"
#include "properties/claims/weak_overlap.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/properties/claim_checks.hpp"
#include "tests/properties/suitability_meshes.hpp"
#include "tests/reference/suitability_claims.hpp"

namespace asts {
namespace {

/// R_axis forgotten.
Verdict forget_region(const Case& content, Axis axis, Trial (*judge)(MeshUnderTest&, const Meeting&)) {
  LastMesh mesh(content);
  PerturbedRegions regions = (*mesh).perturbed_regions();
  regions[at(axis)].clear();
  return judge(*mesh, find_meeting(regions)).verdict;
}

/// Slices of the active region in place of the closed domain's.
Verdict active_slices(const char* id, Trial (*judge)(MeshUnderTest&, const Meeting&)) {
  LastMesh mesh(finding(id));
  return judge(*mesh, (*mesh).meeting_regions()).verdict;
}

/// Index vectors along x taken to be equal: overlap along them is never denied.
Verdict forget_vectors(const Case& content, Trial (*judge)(MeshUnderTest&, const Incompatible&)) {
  LastMesh mesh(content);
  Bricks bricks = (*mesh).bricks();
  for (Brick& brick : bricks.bricks) brick.profile[0] = 0;
  return judge(*mesh, find_incompatible((*mesh).splines(), bricks)).verdict;
}

/// Supports that share volume in place of closed supports that meet.
Verdict open_supports() {
  LastMesh mesh(finding("dc-implies-as"));
  return judge_dc_implies_as(*mesh, (*mesh).incompatible()).verdict;
}

/// N_y(q) in place of N_x(q): the axes of a cube's lines are mixed up.
SliceNodes mixed_up(MeshUnderTest& mesh) {
  const SliceNodes right(mesh);
  SliceNodes wrong(mesh);
  for (std::int32_t rank = 0; rank < static_cast<std::int32_t>(mesh.mesh().coordinates[0].size()); ++rank) {
    for (std::int32_t node = 0; node < mesh.splines().size(); ++node) {
      wrong.set(0, rank, node, right.contains(1, rank, node));
    }
  }
  return wrong;
}

Verdict mixed_up_lemma() {
  LastMesh mesh(crossing());
  return judge_perturbed_means_no_overlap(*mesh, mixed_up(*mesh)).verdict;
}

Verdict mixed_up_cases(CaseConclusion conclusion) {
  LastMesh mesh(crossing());
  return judge_cases(*mesh, mixed_up(*mesh), conclusion).verdict;
}

/// One row of the table lists another case.
Verdict wrong_row() {
  std::vector<CaseRow> table(printed_case_table().begin(), printed_case_table().end());
  table.front().cases = {3};
  return judge_case_table(table, CaseHeads::repaired).verdict;
}

/// The general definition looks at x and y only.
Verdict forgotten_direction() {
  LastMesh mesh(text_case("domain 4 4 5\n"));
  constexpr std::array<Axis, 2> kAxes{0, 1};
  return judge_weak_overlap(*mesh, kAxes).verdict;
}

bool literally(const Case& content, const std::string& id) {
  const auto literal =
      reference::decide_suitability_claims(literal::setting(setting_of(content)), literal::last_mesh(content), 40);
  const auto found = literal.verdicts.find(id);
  return found != literal.verdicts.end() && found->second == reference::Verdict::violated;
}

}  // namespace

std::vector<NegativeControl> suitability_controls() {
  return {
      {"perturbed-means-no-overlap", "N_y(q) in place of N_x(q)", mixed_up_lemma},
      {"as-implies-dc", "R_y forgotten", [] { return forget_region(crossing(), 1, judge_as_implies_dc); }},
      {"as-implies-dc-repaired", "slices of the active region only",
       [] { return active_slices("as-implies-dc", judge_as_implies_dc_repaired); }},
      {"dc-implies-as", "index vectors along x taken to be equal",
       [] { return forget_vectors(crossing(), judge_dc_implies_as); }},
      {"dc-implies-as-repaired", "supports that share volume in place of supports that meet", open_supports},
      {"case-table", "N_y(q) in place of N_x(q)", [] { return mixed_up_cases(CaseConclusion::not_dual_compatible); }},
      {"case-table-repaired", "N_y(q) in place of N_x(q)",
       [] { return mixed_up_cases(CaseConclusion::no_partial_overlap); }},
      {"case-table-repaired", "a row that lists another case", wrong_row},
      {"dc-implies-dual-basis", "index vectors along x taken to be equal",
       [] { return forget_vectors(crossing(), judge_dc_implies_dual_basis); }},
      {"as-implies-dual-basis", "R_y forgotten",
       [] { return forget_region(crossing(), 1, judge_as_implies_dual_basis); }},
      {"as-implies-dual-basis-repaired", "slices of the active region only",
       [] { return active_slices("as-implies-dual-basis", judge_as_implies_dual_basis); }},
      {"dc-within-weak-dc", "a direction forgotten in the general definition", forgotten_direction},
  };
}

std::vector<Confirmation> suitability_confirmations() {
  std::vector<Confirmation> confirmations;
  for (const char* id : {"as-implies-dc", "dc-implies-as", "case-table", "as-implies-dual-basis"}) {
    confirmations.push_back({id, [id](const Case& counterexample) { return literally(counterexample, id); }});
  }
  return confirmations;
}

}  // namespace asts
