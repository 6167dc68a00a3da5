#pragma once

#include "tests/reference/claim_witness.hpp"
#include "tests/reference/complexity_claims.hpp"
#include "tests/reference/lambda_chain.hpp"

/// The checks of the witnesses of Section 7; reports/WITNESS.md says what each kind says.
namespace asts::reference {

std::string check_too_far(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_too_far_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_too_many_elements(ClaimSubject& subject, const nlohmann::json& witness);

std::string check_sum_below_1(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_sum_below_1_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_sum_above_c(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_sum_above_c_repaired(ClaimSubject& subject, const nlohmann::json& witness);

std::string check_ratio(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_ratio_repaired(ClaimSubject& subject, const nlohmann::json& witness);
std::string check_other_limit(ClaimSubject& subject, const nlohmann::json& witness);

/// The constants of a repaired claim: the repaired ones, and the printed ones for m <= 1267. A witness may be about
/// either.
std::vector<DistanceConstant> repaired_constants(const Setting& setting);

/// Checks with each of the constants; the first that does not reject is the answer, else the last rejection stands.
template <class Check>
std::string with_any(const std::vector<DistanceConstant>& constants, const Check& check) {
  for (std::size_t i = 0; i + 1 < constants.size(); ++i) {
    try {
      return check(constants[i]);
    } catch (const Rejected&) {
    }
  }
  return check(constants.back());
}

/// A sequence of calls of Algorithm 2.9, on the set of subdivided elements.
struct LiteralSequence {
  SubdividedSet mesh;                      ///< the last one
  std::vector<GridBox> marks;              ///< of all steps, each step's ones once
  std::vector<std::size_t> marked, fresh;  ///< for each step: how many marks, and |G_j \ G_0|
};

/// The first steps of the subject's sequence. Throws Rejected when a step is a bare subdivision, a mark lies outside of
/// the domain, or the levels are too high for whole numbers of 62 bits.
LiteralSequence follow_literally(const ClaimSubject& subject, std::size_t steps);

}  // namespace asts::reference
