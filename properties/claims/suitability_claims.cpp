#include <array>

#include "properties/claims/case_table.hpp"
#include "properties/claims/claim.hpp"
#include "properties/claims/perturbed_overlap.hpp"
#include "properties/claims/suitability_chain.hpp"
#include "properties/claims/weak_overlap.hpp"

namespace asts {

namespace {

constexpr const char* kOverlapFails =
    "pairs of groups of nodes with common index vectors, whose supports share volume and which fail to overlap along "
    "an axis";
constexpr const char* kRegions = "perturbed regions R_x, R_y, R_z that are not empty";

constexpr std::array kClaims{
    Claim{.id = "perturbed-means-no-overlap",
          .source = "Lemma 6.5",
          .statement = "q in [0,X~], v1 in N_x(q), v2 in N_A \\ N_x(q), S_x(q) cap supp B_v1 cap supp B_v2 not empty: "
                       "xx(v1) and xx(v2) do not overlap; likewise along y and z",
          .kind = ClaimKind::lemma,
          .meshes = "are",
          .met_means = "slices and pairs of nodes (q, v1, v2) that satisfy the hypothesis",
          .on_mesh = perturbed_means_no_overlap,
          .max_elements = 200,
          .reflects = true},
    Claim{.id = "as-implies-dc",
          .source = "Theorem 6.6, AS within DC",
          .statement = "R_x cap R_y = R_y cap R_z = R_z cap R_x = {} implies that any two active nodes whose supports "
                       "share volume have index vectors that overlap along two axes",
          .kind = ClaimKind::theorem,
          .meshes = "are",
          .met_means = kOverlapFails,
          .refuted = true,
          .on_mesh = as_implies_dc,
          .max_elements = 1000,
          .reflects = true,
          .of_splines = true},
    Claim{.id = "as-implies-dc-repaired",
          .source = "Theorem 6.6, AS within DC",
          .statement =
              "the same with slices {x = q} of the closed domain in place of slices of AR in R_x, R_y, R_z; and "
              "admissible meshes are analysis-suitable in this sense",
          .kind = ClaimKind::theorem,
          .meshes = "are",
          .met_means = kOverlapFails,
          .on_mesh = as_implies_dc_repaired,
          .reflects = true},
    Claim{.id = "dc-implies-as",
          .source = "Theorem 6.6, DC within AS",
          .statement = "if any two active nodes whose supports share volume have index vectors that overlap along two "
                       "axes, then R_x cap R_y = R_y cap R_z = R_z cap R_x = {}",
          .kind = ClaimKind::theorem,
          .meshes = "are",
          .met_means = kRegions,
          .refuted = true,
          .on_mesh = dc_implies_as,
          .max_elements = 1000,
          .reflects = true,
          .of_splines = true},
    Claim{.id = "dc-implies-as-repaired",
          .source = "Theorem 6.6, DC within AS",
          .statement = "the same for any two active nodes whose closed supports meet, if only in a face, an edge or a "
                       "point",
          .kind = ClaimKind::theorem,
          .meshes = "are",
          .met_means = kRegions,
          .on_mesh = dc_implies_as_repaired,
          .reflects = true,
          .of_splines = true},
    Claim{.id = "case-table",
          .source = "Figure after Theorem 6.6, and the five cases of its proof",
          .statement = "in all 16 situations the row of the table, read with its printed heads, lists the cases that "
                       "apply, and there is one; where perturbed regions meet, the two nodes of each case do not "
                       "partially overlap and their supports share volume, so that the mesh is not dual-compatible",
          .kind = ClaimKind::figure,
          .meshes = "r",
          .met_means = "situations: of the table, or pairs of slices and nodes of a case in a mesh",
          .refuted = true,
          .on_mesh = cases,
          .alone = case_table,
          .max_elements = 200,
          .reflects = true},
    Claim{.id = "case-table-repaired",
          .source = "Figure after Theorem 6.6, and the five cases of its proof",
          .statement =
              "the same with the heads v3 in N_x(q), v4 in N_x(q), and without common volume: the two nodes of "
              "each case do not partially overlap, and their closed supports meet",
          .kind = ClaimKind::figure,
          .meshes = "r",
          .met_means = "situations: of the table, or pairs of slices and nodes of a case in a mesh",
          .on_mesh = cases_repaired,
          .alone = case_table_repaired,
          .max_elements = 200,
          .reflects = true},
    Claim{.id = "dc-implies-dual-basis",
          .source = "Theorem 6.7",
          .statement = "a dual-compatible mesh has lambda_v(B_w) = delta_vw for all active nodes v, w",
          .kind = ClaimKind::theorem,
          .meshes = "are",
          .met_means = kOverlapFails,
          .on_mesh = dc_implies_dual_basis,
          .reflects = true,
          .of_splines = true},
    Claim{.id = "as-implies-dual-basis",
          .source = "Figure 1: Theorem 6.6 and Theorem 6.7",
          .statement = "R_x cap R_y = R_y cap R_z = R_z cap R_x = {} implies lambda_v(B_w) = delta_vw for all active "
                       "nodes v, w",
          .kind = ClaimKind::theorem,
          .meshes = "are",
          .met_means = kOverlapFails,
          .refuted = true,
          .on_mesh = as_implies_dual_basis,
          .reflects = true,
          .of_splines = true},
    Claim{.id = "as-implies-dual-basis-repaired",
          .source = "Figure 1: Theorem 6.6 and Theorem 6.7",
          .statement = "the same with slices {x = q} of the closed domain in place of slices of AR in R_x, R_y, R_z",
          .kind = ClaimKind::theorem,
          .meshes = "are",
          .met_means = kOverlapFails,
          .on_mesh = as_implies_dual_basis_repaired,
          .reflects = true,
          .of_splines = true},
    Claim{
        .id = "dc-within-weak-dc",
        .source = "remark to Definition 6.4",
        .statement = "two different active nodes that overlap along two axes have different, overlapping index vectors "
                     "along some axis; for nodes of one plane of an extruded planar mesh, overlap along one of the two "
                     "axes and different, overlapping vectors along one of them are equivalent",
        .kind = ClaimKind::remark,
        .meshes = "re",
        .met_means = "pairs of nodes that overlap along two axes and not along the third; in planes, along one of two",
        .on_mesh = dc_within_weak_dc,
        .reflects = true},
};

}  // namespace

std::span<const Claim> suitability_claims() { return kClaims; }

}  // namespace asts
