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

template <std::size_t N>
std::string joined(const std::array<int, N>& numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

std::string bounds_text(const LedgerBounds& bounds) {
  if (bounds.grading == 0) return "";
  return fmt::format("{} | {} | {} | {} | {}", joined(bounds.degree), bounds.grading, joined(bounds.domain),
                     bounds.level, bounds.elements);
}

std::string markdown_row(const LedgerRecord& record) {
  const std::string bounds = bounds_text(record.bounds);
  return fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} | {} |\n", record.claim, status_of(record),
                     result_name(record.result()), record.meshes, record.sequences, record.trials_met, record.met,
                     record.violated, bounds.empty() ? "| | | |" : bounds);
}

std::string tally_markdown(const LedgerRecord& record) {
  if (record.biases.empty()) return {};
  std::string result = fmt::format("- `{}`:", record.claim);
  for (const auto& [name, count] : record.features) result += fmt::format(" {} {},", name, count);
  result += record.features.empty() ? "" : " of";
  for (const auto& [name, count] : record.biases) result += fmt::format(" {} {},", name, count);
  result.back() = '\n';
  return result;
}

}  // namespace

std::string ledger_text(std::span<const LedgerRecord> records) {
  std::string result = fmt::format(fmt::runtime(kRow), "claim", "status", "result", "meshes", "sequences", "alone",
                                   "holds", "violated", "not-appl.", "undecided", "trials-met", "met");
  for (const LedgerRecord& record : records) result += text_row(record);
  for (const LedgerRecord& record : records) result += violation_text(record);
  return result;
}

std::string ledger_markdown(std::span<const LedgerRecord> records) {
  std::string result =
      "| claim | status | result | distinct meshes | sequences | trials met | met | violated | degree | m | domain | "
      "level | elements |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const LedgerRecord& record : records) result += markdown_row(record);
  result += "\nWhere the decided trials came from (features of the meshes, then biases of the cases):\n\n";
  for (const LedgerRecord& record : records) result += tally_markdown(record);
  return result;
}

}  // namespace asts
