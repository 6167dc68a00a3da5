#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mesh/setting.hpp"
#include "properties/ledger/record.hpp"

namespace asts {

/// One of the checked-in enumerations: every mesh of this kind was tried.
struct ExhaustiveRecord {
  std::string claim;
  Setting setting;
  int max_subdivisions = 0;
  bool admissible = false;
  std::int64_t meshes = 0;
  std::int64_t applicable = 0;
  std::int64_t violations = 0;
  std::int64_t met = 0;
};

/// What the long run, whose results are under reports/ledger, found out about one claim.
struct CheckedInRecord {
  std::string status;  ///< of the claim when the run was made
  LedgerRecord record;
  std::vector<ExhaustiveRecord> exhaustive;
};

/// The lines of reports/ledger/*.jsonl as they were when the program was built.
const char* checked_in_lines();

/// By claim. A claim that has only been enumerated has a record with zeros.
using CheckedInLedger = std::map<std::string, CheckedInRecord, std::less<>>;

/// Reads lines of `asts ledger --format json`, and of `asts enumerate --format json` with the setting in front as
/// build.sh writes them. Throws InputError "LINE: reason".
CheckedInLedger read_ledger(std::string_view lines);

/// That of checked_in_lines().
const CheckedInLedger& checked_in_ledger();

/// All of it as Markdown, in the order of the claims: two tables, and where the random meshes came from.
std::string ledger_markdown(const CheckedInLedger& ledger);

/// The part of a claim's record that `asts claims` shows: one line, empty when the claim was not tried.
std::string tried_text(std::string_view claim);

}  // namespace asts
