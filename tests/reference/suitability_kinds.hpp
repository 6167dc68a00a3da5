#pragma once

#include "tests/reference/claim_witness.hpp"

/// The checks of the witnesses of Section 6's claims: one function a form.
namespace asts::reference {

/// Lemma 6.5.
std::string check_overlapping_all_the_same(ClaimSubject& subject, const nlohmann::json& witness);

/// Theorems 6.6, 6.7 and Figure 1: the hypothesis by the definitions, the failing conclusion by the witness.
std::string check_as_implies_dc(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_as_implies_dc_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_admissible_not_suitable(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_dc_implies_as(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_dc_implies_as_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_dc_implies_dual_basis(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_as_implies_dual_basis(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_as_implies_dual_basis_repaired(ClaimSubject& subject, const nlohmann::json& witness);

/// The figure after Theorem 6.6, and the cases of its proof.
std::string check_case_table(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_case_table_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_case(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_case_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_no_case(ClaimSubject& subject, const nlohmann::json& witness);

/// The remark to Definition 6.4.
std::string check_weak_overlap(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_weak_overlap_in_plane(ClaimSubject& subject, const nlohmann::json& witness);

}  // namespace asts::reference
