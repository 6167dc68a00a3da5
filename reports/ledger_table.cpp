#include <fmt/format.h>

#include "lib/mesh/case_file.hpp"
#include "reports/ledger_report.hpp"

namespace asts {

namespace {

constexpr const char* kRow = "{:<32} {:<9} {:<12} {:>9} {:>9} {:>5} {:>9} {:>9} {:>9} {:>9} {:>11} {:>12}\n";

std::string text_row(const LedgerRecord& record) {
  return fmt::format(fmt::runtime(kRow), record.claim, status_of(record), result_name(record.result()), record.meshes,
                     record.sequences, record.alone, record.holds, record.violated, record.not_applicable,
                     record.undecided, record.trials_met, record.met);
}

/// What violates a claim, below a table.
std::string violation_text(const LedgerRecord& record) {
  if (!record.smallest) return {};
  const std::string content = record.smallest->content ? write_case(*record.smallest->content) : std::string();
  return fmt::format("\n# {} ({}) is violated; the smallest case found:\n{}{}\n", record.claim, status_of(record),
                     content, record.smallest->says);
}

}  // namespace

std::string ledger_text(std::span<const LedgerRecord> records) {
  std::string result = fmt::format(fmt::runtime(kRow), "claim", "status", "result", "meshes", "sequences", "alone",
                                   "holds", "violated", "not-appl.", "undecided", "trials-met", "met");
  for (const LedgerRecord& record : records) result += text_row(record);
  for (const LedgerRecord& record : records) result += violation_text(record);
  return result;
}

}  // namespace asts
