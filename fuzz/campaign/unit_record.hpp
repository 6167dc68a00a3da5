#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/plan.hpp"
#include "properties/ledger/record.hpp"

namespace asts {

/// How a claim was violated within a unit, once for each kind of violation.
struct UnitViolation {
  std::string claim;
  std::string kind;
  std::optional<std::int64_t> number;  ///< of the first such case; none: tried without a case
  std::int64_t step = 0;               ///< of that case
  std::int64_t count = 0;              ///< how often
  std::string says;                    ///< the witness in words, when there is no case

  friend bool operator==(const UnitViolation&, const UnitViolation&) = default;
};

/// The code under test did not come back.
struct UnitDeath {
  std::string claim;                   ///< that was being tried; empty when none was
  std::string kind;                    ///< one of kDeathKinds
  std::optional<std::int64_t> number;  ///< of the case; none: tried without a case
  std::int64_t step = -1;              ///< of that case; -1 while it was being made
  std::string says;                    ///< the signal, or what the exception said

  friend bool operator==(const UnitDeath&, const UnitDeath&) = default;
};

/// What a unit gave.
struct UnitRecord {
  std::int64_t unit = 0;
  std::int64_t end = 0;              ///< of a block: behind the number of its last case, skipped ones too
  std::int64_t cases = 0;            ///< that were made
  std::int64_t meshes = 0;           ///< that they made
  std::int64_t trivial = 0;          ///< of those that occurred for the first time
  std::int64_t sequences = 0;        ///< cases of `refine` steps alone
  std::vector<std::uint64_t> fresh;  ///< the meshes that occurred for the first time, in order
  std::map<std::string, std::int64_t> biases;
  std::map<std::string, std::map<std::int64_t, std::int64_t>> generated;  ///< as in CampaignSummary
  std::map<std::string, LedgerRecord> records;  ///< by claim, of those that were tried; without `smallest`
  std::vector<UnitViolation> violations;        ///< by claim in the plan's order, then kind
  std::vector<UnitDeath> deaths;
};

/// A record as JSON, without a line end; and back. unit_from_json throws InputError for what is none.
/// Law (tests/fuzz/unit_record_test.cpp): reading what was written gives the record.
std::string unit_json(const UnitRecord& record);
UnitRecord unit_from_json(std::string_view text);

/// Words as 16 hexadecimal digits each; and back. Throws InputError.
std::string hex_of(const std::vector<std::uint64_t>& words);
std::vector<std::uint64_t> words_of(std::string_view text);

}  // namespace asts
