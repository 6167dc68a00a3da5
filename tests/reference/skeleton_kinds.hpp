#pragma once

#include "tests/reference/claim_witness.hpp"

/// The checks of the witnesses of the claims of Sections 4 and 5 up to Definition 5.2: one function a form.
namespace asts::reference {

std::string check_frame_entry(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_frame_entry_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_index_vector(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_perturbed_uniform_mesh(ClaimSubject& subject, const nlohmann::json& witness);

std::string check_hanging_node(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_hanging_edge(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_hanging_node_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_hanging_edge_repaired(ClaimSubject& subject, const nlohmann::json& witness);

std::string check_only_extensions_meet(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_only_extensions_meet_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_only_regions_meet(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_only_regions_meet_repaired(ClaimSubject& subject, const nlohmann::json& witness);

/// The figures after Definition 5.2; no mesh is needed.
std::string check_slice_figure(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_caption(ClaimSubject& subject, const nlohmann::json& witness);

/// The figures in the proof of Theorem 5.3; no mesh is needed for check_no_degree.
std::string check_proof_figure(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_proof_figure_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_no_degree(ClaimSubject& subject, const nlohmann::json& witness);

}  // namespace asts::reference
