#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "properties/ledger/record.hpp"

namespace asts {

/// The words for a violation: the witness for a person, or the reason.
std::string violation_text(const Verdict& verdict);

/// The status of the record's claim: "unrefuted", "refuted", or "unknown" when no claim has the id.
const char* status_of(const LedgerRecord& record);

/// A record as one line of JSON, with a line end; and back. ledger_from_json throws InputError for a line that is none.
/// Law (tests/properties/ledger_test.cpp): reading what was written gives the record.
std::string ledger_json(const LedgerRecord& record);
LedgerRecord ledger_from_json(std::string_view line);

/// The bounds alone, as in a record.
nlohmann::ordered_json bounds_json(const LedgerBounds& bounds);

/// For a person: a table, and below it what violates a claim.
std::string ledger_text(std::span<const LedgerRecord> records);

}  // namespace asts
