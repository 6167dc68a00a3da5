#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mesh/case.hpp"
#include "lib/minimize/minimize.hpp"
#include "properties/ledger/record.hpp"

namespace asts {

/// How a finding came to be as small as it is.
struct FindingSize {
  CaseSize size;
  Guarantee guarantee = Guarantee::one_minimal;
  std::int64_t evaluations = 0;
};

/// How the code under test may end when it does not come back: the kinds of findings that are no violations.
inline constexpr const char* kCrash = "crash";          ///< a signal
inline constexpr const char* kTimeout = "timeout";      ///< no end within the limit
inline constexpr const char* kOutOfMemory = "memory";   ///< no memory within the limit
inline constexpr const char* kException = "exception";  ///< one that it should not throw
inline constexpr std::array<std::string_view, 4> kDeathKinds{kCrash, kTimeout, kOutOfMemory, kException};

/// Something that a campaign found: once for each claim, kind and canonical case.
struct CampaignFinding {
  std::string claim;  ///< its id; empty when no claim was being tried
  /// The kind of the witness, or one of kDeathKinds.
  std::string kind;
  /// A violation of a claim that is refuted already. Nothing else is expected.
  bool expected = false;
  /// Of the first case that led to it; below 0: -1 minus its place among the stored cases; none: tried without a case.
  std::optional<std::int64_t> number;
  std::int64_t step = 0;        ///< of that case: how many steps make the mesh
  std::optional<Case> content;  ///< minimized, or as drawn when `minimized` is missing
  std::optional<FindingSize> minimized;
  std::string file;  ///< "findings/<claim>-<kind>-<hash>.case" in the run directory; empty without a case
  std::string says;  ///< the witness in words, or what happened
  /// What the literal code says of the witness; missing when there is no witness in a case.
  std::optional<bool> valid;
  std::string validation;
};

/// Why a campaign says less than it seems to.
struct HealthProblem {
  /// "trivial-meshes", "repeated-meshes", "never-tried", "hypothesis-never-met", "bias-never-fired", "slow-case"
  std::string check;
  std::string subject;  ///< the claim or the bias; may be empty
  std::string says;     ///< with the numbers
};

/// What a campaign gives. Depends on the claims, the seed and the number of cases alone: there is no time in it.
struct CampaignSummary {
  std::string version;  ///< of the program
  std::vector<std::string> claims;
  std::uint64_t seed = 1;
  std::int64_t cases = 0;   ///< that were made
  std::int64_t meshes = 0;  ///< that they made, repeated ones too
  /// Of these; a mesh of a case that was drawn for one claim counts by itself, as it is tried on that claim alone.
  std::int64_t distinct = 0;
  std::int64_t trivial = 0;    ///< of the distinct ones: nothing is subdivided, and each element is a unit cube
  std::int64_t sequences = 0;  ///< cases of `refine` steps alone
  std::int64_t deaths = 0;     ///< how often the code under test did not come back
  /// Cases by what they were drawn to provoke: every bias that there is, with 0 for one that never occurred.
  std::map<std::string, std::int64_t> biases;
  /// Distinct meshes by "level" (the highest), "elements" (the lowest power of 2 that is not less), "grading" (m),
  /// "degree" (the highest of the three), "volume" (of the domain; the lowest power of 2 that is not less).
  std::map<std::string, std::map<std::int64_t, std::int64_t>> generated;
  /// In the order of `claims`; `smallest` is not set: findings say more.
  std::vector<LedgerRecord> records;
  std::vector<CampaignFinding> findings;  ///< in the order in which they are found
};

}  // namespace asts
