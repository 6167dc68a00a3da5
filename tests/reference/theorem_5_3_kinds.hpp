#pragma once

#include "tests/reference/claim_witness.hpp"
#include "tests/reference/theorem_5_3_step.hpp"

/// The checks of the witnesses against Theorem 5.3 and the steps of its proof: one function a form.
namespace asts::reference {

/// The step that a witness is about, where the proof's hypotheses hold: G is admissible and analysis-suitable, and so
/// is the subdivision of `element`. Throws Rejected otherwise.
struct StepSubject {
  Step step;
  Space<Rational> after;   ///< G^
  std::string hypotheses;  ///< in words
};
StepSubject read_step(ClaimSubject& subject, const nlohmann::json& element);

/// A number as a coordinate, in units of 1/scale. Throws Rejected when it is none of the mesh's, nor halfway between.
Grid read_units(const Step& step, const nlohmann::json& number);
PointIn<Grid> read_units_point(const Step& step, const nlohmann::json& point);
/// One of the xi.
Grid read_xi(const Step& step, const nlohmann::json& number);

std::string check_admissible_implies_as(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_region_changed(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_sigma_meets_region(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_new_node_split(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_new_node_split_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_larger_sigma(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_outside_old_region(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_second_patch(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_sigma_too_large(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_node_too_far(ClaimSubject& subject, const nlohmann::json& witness);

}  // namespace asts::reference
