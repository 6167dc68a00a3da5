#pragma once

#include "tests/reference/spline.hpp"
#include "tests/reference/witness_json.hpp"

/// One function a witness kind. Each returns the report, or throws Rejected with the reason.
namespace asts::reference {

std::string validate_coarser_in_patch(const Setting& setting, const Mesh& mesh, const nlohmann::json& witness);
std::string validate_outside_class(const Setting& setting, const Mesh& mesh, const nlohmann::json& witness);
std::string validate_patch_not_nested(const Setting& setting, const Mesh& mesh, const nlohmann::json& witness);
std::string validate_perturbed_regions_meet(const Setting& setting, const Mesh& mesh, const nlohmann::json& witness);
std::string validate_no_partial_overlap(const Setting& setting, const Mesh& mesh, const nlohmann::json& witness);
std::string validate_lambda_not_delta(const Setting& setting, const Mesh& mesh, const nlohmann::json& witness);

/// An active node of the witness: is it an active node of the mesh, and are its printed index vectors and support those
/// of Definition 4.4?
ActiveNode<Rational> checked_active_node(const Space<Rational>& space, const nlohmann::json& value,
                                         const std::string& what);

/// Rejects the witness when an active node has no index vector: then no B_v is defined for it and the properties of
/// Sections 5 and 6 do not apply. Returns what was looked at, in words; large meshes are not searched, and it says so.
std::string check_property_applies(const Setting& setting, const Mesh& mesh);

}  // namespace asts::reference
