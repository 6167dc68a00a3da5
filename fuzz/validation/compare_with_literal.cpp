#include "fuzz/validation/compare_with_literal.hpp"

#include <fmt/format.h>

#include "fuzz/validation/literal_case.hpp"
#include "properties/properties.hpp"
#include "reports/witness_json.hpp"
#include "tests/reference/validate.hpp"

namespace asts {

namespace {

std::optional<LiteralDifference> compare_verdict(const Property& property, const Verdict& verdict,
                                                 const std::string& expected, const reference::Setting& setting,
                                                 const reference::Mesh& boxes) {
  const std::string outcome = outcome_name(verdict.outcome);
  if (outcome != expected) return {{property.id, fmt::format("{}, by the literal code {}", outcome, expected)}};
  if (verdict.witness.has_value() != (verdict.outcome == Outcome::violated)) {
    return {{property.id, "a witness goes with a violation and with nothing else"}};
  }
  if (!verdict.witness) return std::nullopt;
  const auto witness = nlohmann::json::parse(witness_json(*verdict.witness).dump());
  const reference::Validation validation = reference::validate_witness(setting, boxes, property.id, witness);
  if (validation.valid) return std::nullopt;
  return {{std::string("the witness against ") + property.id,
           fmt::format("{} is not valid: {}", witness.dump(), validation.report)}};
}

}  // namespace

std::optional<LiteralDifference> compare_with_literal(MeshUnderTest& mesh, const reference::Setting& setting,
                                                      const reference::Mesh& boxes) {
  if (literal::sorted(literal::mesh(mesh.mesh())) != literal::sorted(boxes)) return {{"the elements", "others"}};
  const reference::Verdicts verdicts = reference::decide(setting, boxes);
  for (const Property& property : all_properties()) {
    const std::string expected = reference::verdict_name(reference::verdict_on(verdicts, property.id));
    auto difference = compare_verdict(property, decide(property, mesh), expected, setting, boxes);
    if (difference) return difference;
  }
  return std::nullopt;
}

}  // namespace asts
