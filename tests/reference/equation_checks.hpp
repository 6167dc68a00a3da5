#pragma once

#include "tests/reference/claim_witness.hpp"

/// The checks of the witnesses of Appendix A; reports/WITNESS.md says what each kind says. Where there is no
/// mesh the numbers decide alone, for any m, degrees and level.
namespace asts::reference {

/// The degrees of a witness: the mesh's, or any of the paper's where there is none. Throws Rejected.
std::array<int, dimension> read_degrees(const ClaimSubject& subject, const nlohmann::json& value);

std::string check_size(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_distance_by_parent(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_distance_by_child(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_repaired_distance(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_radius_step(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_child_bound(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_repaired_child_bound(ClaimSubject& subject, const nlohmann::json& witness);

std::string check_radius_bound(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_size_bound(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_size_grows(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_patch_distance(ClaimSubject& subject, const nlohmann::json& witness);

}  // namespace asts::reference
