#pragma once

#include "tests/reference/claim_witness.hpp"

/// The checks of the witnesses of Sections 2 and 3 and of the outlook; reports/WITNESS.md says what each kind says.
/// All of these claims are expected to hold, so nothing but a fault in the paper's own definitions passes them.
namespace asts::reference {

std::string check_example_table(ClaimSubject& subject, const nlohmann::json& witness);

std::string check_closure_not_least(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_closure_depends_on_loop(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_closure_depends_on_marks(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_closure_not_idempotent(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_closure_not_monotone(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_closure_not_mirrored(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_order_matters(ClaimSubject& subject, const nlohmann::json& witness);

std::string check_environment_lower(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_environment_upper(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_radius_not_linear(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_radius_not_decreasing(ClaimSubject& subject, const nlohmann::json& witness);

std::string check_refined_not_admissible(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_subdivision_not_admissible(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_refine_subdivides_others(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_level_order(ClaimSubject& subject, const nlohmann::json& witness);

std::string check_patch_not_nested(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_levels_change(ClaimSubject& subject, const nlohmann::json& witness);

std::string check_overlay_not_admissible(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_overlay_too_large(ClaimSubject& subject, const nlohmann::json& witness);

}  // namespace asts::reference
