#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/properties/claim_witness_checks.hpp"

/// For tests that hand the witnesses of the claims to the literal code.
namespace asts {

using witness_checks::json_of;
using witness_checks::validated;

/// The witness of a claim for a case's last mesh; null when it is not violated.
inline nlohmann::json witness_of(const std::string& claim, const Case& content) {
  const Verdict verdict = try_on_case(find_statement(claim).value(), content).verdict;
  return verdict.outcome == Outcome::violated ? json_of(verdict) : nlohmann::json();
}

inline Case finding_case(const std::string& name) { return witness_checks::finding(name); }

/// The program's witness for the case is valid, and its report has all the texts.
inline void expect_valid(const std::string& claim, const Case& content, const std::vector<std::string>& texts) {
  const nlohmann::json witness = witness_of(claim, content);
  ASSERT_FALSE(witness.is_null()) << claim << " is not violated";
  const reference::Validation result = validated(content, claim, witness);
  EXPECT_TRUE(result.valid) << claim << ": " << result.report << "\n" << witness.dump(1);
  for (const std::string& text : texts) EXPECT_NE(result.report.find(text), std::string::npos) << result.report;
}

/// One change of a witness, which makes it false or malformed.
struct WitnessCorruption {
  const char* pointer;  ///< into the witness; with a new key, that is added
  const char* value;    ///< JSON; empty: the key is removed
  const char* reason;   ///< a part of the reason that the literal code gives
};

inline nlohmann::json corrupted(nlohmann::json witness, const WitnessCorruption& corruption) {
  const nlohmann::json::json_pointer pointer(corruption.pointer);
  if (*corruption.value != '\0') {
    witness[pointer] = nlohmann::json::parse(corruption.value);
  } else {
    witness[pointer.parent_pointer()].erase(pointer.back());
  }
  return witness;
}

/// Each one changes the witness, and is rejected for its reason.
inline void expect_rejected(const std::string& claim, const Case& content, const nlohmann::json& witness,
                            const std::vector<WitnessCorruption>& corruptions) {
  for (const WitnessCorruption& corruption : corruptions) {
    const nlohmann::json bad = corrupted(witness, corruption);
    EXPECT_NE(bad, witness) << corruption.pointer;
    const reference::Validation result = validated(content, claim, bad);
    EXPECT_FALSE(result.valid) << claim << " " << corruption.pointer << ": " << result.report;
    EXPECT_NE(result.report.find(corruption.reason), std::string::npos)
        << claim << " " << corruption.pointer << ": " << result.report;
  }
}

/// The witness that a claim's planted fault (claim_checks.hpp) makes.
struct PlantedWitness {
  const char* claim;
  const char* fault;
  Case content;        ///< the mesh in which the fault was planted, which does not violate the claim
  const char* reason;  ///< a part of the reason that the literal code gives
};

/// No mesh violates the claims for a fault in what looks at it: the literal code rejects each witness for its reason.
inline void expect_planted_rejected(const std::vector<NegativeControl>& controls,
                                    const std::vector<PlantedWitness>& planted) {
  for (const PlantedWitness& one : planted) {
    const auto control = std::find_if(controls.begin(), controls.end(), [&](const NegativeControl& candidate) {
      return std::string(candidate.claim) == one.claim && std::string(candidate.fault) == one.fault;
    });
    ASSERT_NE(control, controls.end()) << one.claim << ": " << one.fault;
    const nlohmann::json witness = json_of(control->run());
    const reference::Validation result = validated(one.content, one.claim, witness);
    EXPECT_FALSE(result.valid) << one.claim << ": " << result.report;
    EXPECT_NE(result.report.find(one.reason), std::string::npos) << one.claim << ": " << result.report << witness;
  }
}

}  // namespace asts
