#include "tests/reference/suitability_kinds.hpp"

namespace asts::reference {

namespace {

constexpr const char* wrong_row = "the table's row for a situation does not list the cases that apply";
constexpr const char* no_case =
    "two perturbed regions meet in the point because of v1, v2 and v3, v4, but none of the cases occurs";

constexpr ClaimKind kinds[] = {
    {"perturbed-means-no-overlap", "perturbed-yet-overlapping",
     "the slice meets both supports, v1 has its projection on it in the skeleton and v2 has not, but their index "
     "vectors "
     "along the axis overlap",
     check_overlapping_all_the_same},
    {"as-implies-dc", "no-partial-overlap", nullptr, check_as_implies_dc},
    {"as-implies-dc-repaired", "no-partial-overlap", nullptr, check_as_implies_dc_repaired},
    {"as-implies-dc-repaired", "perturbed-regions-meet", nullptr, check_admissible_not_suitable},
    {"dc-implies-as", "perturbed-regions-meet", nullptr, check_dc_implies_as},
    {"dc-implies-as-repaired", "perturbed-regions-meet", nullptr, check_dc_implies_as_repaired},
    {"case-table", "case-table-disagrees", wrong_row, check_case_table},
    {"case-table", "case-without-conclusion",
     "the nodes are as a case of the proof has them, but they partially overlap, or their supports share no volume",
     check_case},
    {"case-table", "no-case", no_case, check_no_case},
    {"case-table-repaired", "case-table-disagrees", wrong_row, check_case_table_repaired},
    {"case-table-repaired", "case-without-conclusion",
     "the nodes are as a case of the proof has them, but they partially overlap", check_case_repaired},
    {"case-table-repaired", "no-case", no_case, check_no_case},
    {"dc-implies-dual-basis", "lambda-not-delta", nullptr, check_dc_implies_dual_basis},
    {"as-implies-dual-basis", "lambda-not-delta", nullptr, check_as_implies_dual_basis},
    {"as-implies-dual-basis-repaired", "lambda-not-delta", nullptr, check_as_implies_dual_basis_repaired},
    {"dc-within-weak-dc", "definitions-disagree",
     "the nodes overlap along two axes, but along no axis they have different, overlapping vectors",
     check_weak_overlap},
    {"dc-within-weak-dc", "definitions-disagree-in-a-plane",
     "the nodes of one plane of a planar mesh overlap along one of its axes, or have different, overlapping vectors "
     "along "
     "one of them, but not both",
     check_weak_overlap_in_plane},
};

}  // namespace

std::span<const ClaimKind> suitability_kinds() { return kinds; }

}  // namespace asts::reference
