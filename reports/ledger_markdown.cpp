#include <fmt/format.h>

#include "reports/checked_in_ledger.hpp"
#include "reports/ledger_report.hpp"

namespace asts {

namespace {

std::string bounds_text(const LedgerBounds& bounds) {
  if (bounds.grading == 0) return "| | | |";
  return fmt::format("{} | {} | {} | {} | {}", fmt::join(bounds.degree, " "), bounds.grading,
                     fmt::join(bounds.domain, " "), bounds.level, bounds.elements);
}

std::string random_row(const LedgerRecord& record) {
  if (record.trials() == 0) return {};
  return fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} | {} |\n", record.claim, status_of(record),
                     result_name(record.result()), record.meshes, record.sequences, record.trials_met, record.met,
                     record.violated, bounds_text(record.bounds));
}

std::string exhaustive_row(const ExhaustiveRecord& one) {
  return fmt::format("| `{}` | {} | {} | {} | {}{} | {} | {} | {} |\n", one.claim, fmt::join(one.setting.degree, " "),
                     one.setting.grading, fmt::join(one.setting.domain, " "), one.max_subdivisions,
                     one.admissible ? ", admissible" : "", one.meshes, one.applicable, one.violations);
}

std::string tally(const std::map<std::string, std::int64_t>& counts) {
  std::string result;
  for (const auto& [name, count] : counts) result += fmt::format("{}{} {}", result.empty() ? "" : ", ", name, count);
  return result;
}

std::string origin_row(const LedgerRecord& record) {
  if (record.biases.empty()) return {};
  return fmt::format("| `{}` | {} | {} |\n", record.claim, tally(record.features), tally(record.biases));
}

constexpr const char* kHead = R"(# Results of the long run

Made by `./build.sh ledger`: `ledger.jsonl` are the records of `asts ledger --long`, `enumerate.jsonl` those of
`asts enumerate`, and `asts ledger --render` prints this page from them.

A trial is one mesh, one sequence of refine steps, or the claim alone (what needs no mesh). "Trials met" counts the trials
in which the claim's hypothesis was met in a way that is not trivial, "met" how often in all: what counts is said in the
claim's source. Degree, m, domain, level and elements are the largest among the trials that were decided.

## Random cases

| claim | status | result | distinct meshes | sequences | trials met | met | violated | degree | m | domain | level | elements |
|---|---|---|---|---|---|---|---|---|---|---|---|---|
)";

constexpr const char* kExhaustive = R"(
## Every mesh of at most so many subdivisions

| claim | degree | m | domain | subdivisions | distinct meshes | applicable | violating |
|---|---|---|---|---|---|---|---|
)";

constexpr const char* kOrigins = R"(
## Where the decided random trials came from

| claim | features of the meshes | biases of the cases |
|---|---|---|
)";

}  // namespace

std::string ledger_markdown(const CheckedInLedger& ledger) {
  std::string random;
  std::string exhaustive;
  std::string origins;
  for (const Claim& claim : all_claims()) {
    const auto found = ledger.find(claim.id);
    if (found == ledger.end()) continue;
    random += random_row(found->second.record);
    for (const ExhaustiveRecord& one : found->second.exhaustive) exhaustive += exhaustive_row(one);
    origins += origin_row(found->second.record);
  }
  return kHead + random + kExhaustive + exhaustive + kOrigins + origins;
}

}  // namespace asts
