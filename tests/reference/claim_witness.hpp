#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "tests/reference/claim_subject.hpp"
#include "tests/reference/validate.hpp"
#include "tests/reference/witness_json.hpp"

namespace asts::reference {

/// Decides a claim's witness from the paper alone. Returns the report: which hypotheses hold and which conclusion
/// fails, with both sides of the violated relation in numbers; throws Rejected with what speaks against the witness.
using ClaimCheck = std::string (*)(ClaimSubject& subject, const nlohmann::json& witness);

/// One form of a witness of a claim. A claim has as many as there are ways to violate it.
struct ClaimKind {
  const char* claim;  ///< its id; a repaired claim has rows of its own
  const char* kind;
  const char* says;  ///< the sentence that stands in the witness; nullptr for the forms of the five properties
  ClaimCheck check;
};

/// All forms of all claims, a family after the other.
std::vector<ClaimKind> all_claim_kinds();

/// The families, each in files of its own.
std::span<const ClaimKind> refinement_kinds();
std::span<const ClaimKind> equation_kinds();
std::span<const ClaimKind> complexity_kinds();
std::span<const ClaimKind> skeleton_kinds();
std::span<const ClaimKind> theorem_5_3_kinds();
std::span<const ClaimKind> suitability_kinds();
std::span<const ClaimKind> functional_kinds();
std::span<const ClaimKind> independence_kinds();

/// Anything malformed gives an invalid result with the reason; nothing is thrown.
Validation validate_claim_witness(ClaimSubject& subject, const std::string& claim, const nlohmann::json& witness);

/// The `values` of a witness, which must have exactly these names. Throws Rejected.
const nlohmann::json& values_of(const nlohmann::json& witness, std::initializer_list<const char*> names);

}  // namespace asts::reference
