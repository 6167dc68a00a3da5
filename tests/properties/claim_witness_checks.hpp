#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "lib/mesh/case_file.hpp"
#include "properties/statement.hpp"
#include "reports/witness_json.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/properties/claim_checks.hpp"
#include "tests/reference/claim_witness.hpp"

/// Witnesses as the program writes them, and the literal code's word on them.
namespace asts::witness_checks {

/// What a case is, for the literal code.
inline reference::ClaimSubject subject_of(const Case& content) {
  const reference::Setting setting = literal::setting(setting_of(content));
  if (content.explicit_mesh) return {setting, literal::last_mesh(content)};
  std::vector<reference::LiteralStep> steps;
  for (const Step& step : content.steps) {
    steps.push_back({step.kind == Step::Kind::refine, {}});
    for (const Point& mark : step.marks) steps.back().marks.push_back(literal::point(mark));
  }
  return {setting, std::move(steps)};
}

/// The counterexample of a finding.
inline Case finding(const std::string& id) {
  return read_case_file(std::string(ASTS_CASES) + "/../../reports/findings/" + id + ".case");
}

/// A verdict's witness as `asts check --format json` has it.
inline nlohmann::json json_of(const Verdict& verdict) {
  return nlohmann::json::parse(witness_json(verdict.witness.value()).dump());
}

inline nlohmann::json witness_of(const char* id, const Case& content) {
  return json_of(try_on_case(find_statement(id).value(), content).verdict);
}

/// The witness under a planted fault.
inline nlohmann::json planted(const std::vector<NegativeControl>& controls, const std::string& claim,
                              const std::string& fault) {
  for (const NegativeControl& control : controls) {
    if (control.claim == claim && control.fault == fault) return json_of(control.run());
  }
  throw std::out_of_range("no control plants the fault: " + fault);
}

inline reference::Validation validated(const Case& content, const std::string& claim, const nlohmann::json& witness) {
  reference::ClaimSubject subject = subject_of(content);
  return reference::validate_claim_witness(subject, claim, witness);
}

/// Without a mesh, by the numbers alone.
inline reference::Validation validated_alone(const std::string& claim, const nlohmann::json& witness) {
  reference::ClaimSubject subject = reference::ClaimSubject::none();
  return reference::validate_claim_witness(subject, claim, witness);
}

}  // namespace asts::witness_checks
