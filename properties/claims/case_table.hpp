#pragma once

#include <array>
#include <span>
#include <vector>

#include "properties/claims/claim.hpp"
#include "properties/claims/slice_nodes.hpp"

/// The five cases in the proof of Theorem 6.6 and the table behind it.
///
/// Given are v_1 in N_x(q), v_2 not in N_x(q), v_3 in N_y(r), v_4 not in N_y(r), and a point of both slices that is in
/// all four supports. The cases ask whether v_1, v_2 are in N_y(r) and whether v_3, v_4 are in N_x(q): 16 situations.
namespace asts {

/// The table's heads for v_3 and v_4: N_y(r) as printed, where the assumption leaves only (true, false); or N_x(q),
/// which is what the cases ask.
enum class CaseHeads { printed, repaired };

struct CaseRow {
  std::array<bool, 4> heads;
  std::vector<int> cases;
};

/// The 16 rows as printed, in their order.
std::span<const CaseRow> printed_case_table();

/// Whether in each of the 16 situations some case applies, and the row that the table has for it lists those that do.
Trial judge_case_table(std::span<const CaseRow> table, CaseHeads heads);

/// What a case is used for: "do not partially overlap, hence not dual-compatible" as printed; without the conclusion
/// drawn from it in the repaired form.
enum class CaseConclusion { not_dual_compatible, no_partial_overlap };

/// Each case, wherever its situation occurs in a mesh. A case's pair is one node of N_x(q) with one that is not in it,
/// one of N_y(r) with one that is not in it, with a common point of the supports in both slices. Such a pair alone
/// makes Case 1: with v_1 the node in N_x(q), v_2 the other, and v_3, v_4 the same two nodes. So all such pairs are
/// looked at.
Trial judge_cases(MeshUnderTest& mesh, const SliceNodes& slice_nodes, CaseConclusion conclusion);

Trial case_table(Extent extent);
Trial case_table_repaired(Extent extent);
Trial cases(MeshUnderTest& mesh);
Trial cases_repaired(MeshUnderTest& mesh);

}  // namespace asts
