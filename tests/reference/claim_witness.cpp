#include "tests/reference/claim_witness.hpp"

#include <algorithm>

namespace asts::reference {

namespace {

std::string text_of(const nlohmann::json& witness, const char* key) {
  if (!witness.is_object() || !witness.contains(key) || !witness[key].is_string())
    throw Rejected(std::string("the witness is not an object with a text \"") + key + "\"");
  return witness[key].get<std::string>();
}

std::string checked(ClaimSubject& subject, const std::string& claim, const nlohmann::json& witness) {
  const std::string kind = text_of(witness, "kind");
  bool known = false;
  for (const ClaimKind& form : all_claim_kinds()) {
    if (claim != form.claim || kind != form.kind) continue;
    known = true;
    if (form.says == nullptr) return form.check(subject, witness);
    if (text_of(witness, "says") != form.says) continue;
    require_keys(witness, {"kind", "says", "values"}, "the witness");
    return form.check(subject, witness);
  }
  throw Rejected(known ? "the witness says something that its kind does not say"
                       : "there is no such kind of witness for this claim");
}

}  // namespace

std::vector<ClaimKind> all_claim_kinds() {
  std::vector<ClaimKind> all;
  for (const auto family : {refinement_kinds, equation_kinds, complexity_kinds, skeleton_kinds, theorem_5_3_kinds,
                            suitability_kinds, functional_kinds, independence_kinds}) {
    const std::span<const ClaimKind> kinds = family();
    all.insert(all.end(), kinds.begin(), kinds.end());
  }
  return all;
}

Validation validate_claim_witness(ClaimSubject& subject, const std::string& claim, const nlohmann::json& witness) {
  try {
    return {true, checked(subject, claim, witness)};
  } catch (const std::exception& reason) {
    return {false, reason.what()};
  }
}

const nlohmann::json& values_of(const nlohmann::json& witness, std::initializer_list<const char*> names) {
  const nlohmann::json& values = witness.at("values");
  require_keys(values, names, "values");
  return values;
}

}  // namespace asts::reference
