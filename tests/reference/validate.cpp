#include "tests/reference/validate.hpp"

#include "tests/reference/validate_kinds.hpp"

namespace asts::reference {

namespace {

using Check = std::string (*)(const Setting&, const Mesh&, const nlohmann::json&);

struct Kind {
  const char* property;
  const char* kind;
  Check check;
};

constexpr Kind kinds[] = {
    {"admissible", "coarser-in-patch", validate_coarser_in_patch},
    {"admissible", "outside-class", validate_outside_class},
    {"nested-patches", "patch-not-nested", validate_patch_not_nested},
    {"analysis-suitable", "perturbed-regions-meet", validate_perturbed_regions_meet},
    {"dual-compatible", "no-partial-overlap", validate_no_partial_overlap},
    {"dual-basis", "lambda-not-delta", validate_lambda_not_delta},
};

std::string checked(const Setting& setting, const Mesh& mesh, const std::string& property,
                    const nlohmann::json& witness) {
  if (!witness.is_object() || !witness.contains("kind") || !witness["kind"].is_string())
    throw Rejected("the witness is not an object with a kind");
  const std::string name = witness["kind"].get<std::string>();
  for (const Kind& kind : kinds) {
    if (property != kind.property || name != kind.kind) continue;
    if (!tiles_domain(setting, mesh)) throw Rejected("the mesh does not tile the domain");
    return kind.check(setting, mesh, witness);
  }
  throw Rejected("there is no such kind of witness for this property");
}

}  // namespace

Validation validate_witness(const Setting& setting, const Mesh& mesh, const std::string& property,
                            const nlohmann::json& witness) {
  try {
    return {true, checked(setting, mesh, property, witness)};
  } catch (const std::exception& reason) {
    return {false, reason.what()};
  }
}

}  // namespace asts::reference
