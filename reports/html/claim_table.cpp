#include "reports/html/claim_table.hpp"

#include <fmt/format.h>

#include <set>

#include "properties/statement.hpp"
#include "reports/ledger_report.hpp"

namespace asts {

namespace {

using Tally = std::map<std::string, std::int64_t>;

const char* source_of(const std::string& claim) {
  const Claim* found = find_claim(claim);
  return found == nullptr ? "-" : found->source;
}

/// In how many of the trials the hypothesis was met.
std::string coverage(const LedgerRecord& record) { return percent(record.trials_met, record.trials()); }

std::vector<HtmlCell> row(const LedgerRecord& record) {
  std::vector<HtmlCell> cells{text_cell(record.claim, statement_id(record.claim)), text_cell(source_of(record.claim)),
                              text_cell(status_of(record)), text_cell(result_name(record.result()))};
  for (const std::int64_t count : {record.meshes, record.sequences, record.alone, record.trials_met}) {
    cells.push_back(number_cell(count));
  }
  cells.push_back({coverage(record), true});
  for (const std::int64_t count :
       {record.met, record.holds, record.violated, record.not_applicable, record.undecided}) {
    cells.push_back(number_cell(count));
  }
  return cells;
}

/// More columns of numbers do not fit on paper.
constexpr std::size_t kMostColumns = 13;

void add_tally_table(HtmlNode parent, const std::string& id, const std::string& caption,
                     std::span<const LedgerRecord> records, const Tally LedgerRecord::*tally,
                     std::span<const std::string> names) {
  HtmlTable table{id, caption, {"claim"}, {}};
  table.columns.insert(table.columns.end(), names.begin(), names.end());
  for (const LedgerRecord& record : records) {
    auto& cells = table.rows.emplace_back();
    cells.push_back(text_cell(record.claim));
    for (const std::string& name : names) {
      const auto found = (record.*tally).find(name);
      cells.push_back(number_cell(found == (record.*tally).end() ? 0 : found->second));
    }
  }
  add_table(parent, table);
}

/// Claims by what their decided trials were drawn for, or had; nothing when there is nothing to say.
void add_tally_tables(HtmlNode parent, const std::string& id, const std::string& caption,
                      std::span<const LedgerRecord> records, const Tally LedgerRecord::*tally) {
  std::set<std::string> all;
  for (const LedgerRecord& record : records) {
    for (const auto& [name, count] : record.*tally) all.insert(name);
  }
  const std::vector<std::string> names(all.begin(), all.end());
  const std::size_t tables = (names.size() + kMostColumns - 1) / kMostColumns;
  for (std::size_t i = 0; i < tables; ++i) {
    const std::size_t begin = i * names.size() / tables;
    const std::size_t end = (i + 1) * names.size() / tables;
    const std::string part = tables > 1 ? fmt::format(", part {} of {}", i + 1, tables) : "";
    add_tally_table(parent, fmt::format("{}-{}", id, i + 1), caption + part, records, tally,
                    std::span(names).subspan(begin, end - begin));
  }
}

}  // namespace

std::string statement_id(const std::string& claim) { return "statement-" + claim; }

std::string sizes_text(const PerAxis<int>& sizes, const char* between) {
  if (sizes == PerAxis<int>{}) return "-";
  return fmt::format("{}{}{}{}{}", sizes[0], between, sizes[1], between, sizes[2]);
}

void add_statement(HtmlNode list, const std::string& id) {
  const auto statement = find_statement(id);
  HtmlNode pair = add_html(list, "div", {{"id", statement_id(id)}});
  add_html(pair, "dt", {}, id);
  HtmlNode words = add_html(pair, "dd");
  if (!statement) return add_words(words, "not known to this version of the program");
  if (statement->claim == nullptr) {
    return add_words(words, fmt::format("{}: {}.", statement->property->source, statement->property->statement));
  }
  const Claim& claim = *statement->claim;
  add_words(words, fmt::format("{}, {}: {}. Its hypothesis is met by {}.", kind_name(claim.kind), claim.source,
                               claim.statement, claim.met_means));
}

void add_bounds_table(HtmlNode parent, const BoundsByName& bounds) {
  HtmlTable table{"bounds-table",
                  "Bounds: the largest of each among the decided trials",
                  {"statement", "domain", "degrees", "m", "level", "elements", "active nodes"},
                  {}};
  for (const auto& [name, one] : bounds) {
    auto& cells = table.rows.emplace_back();
    cells = {text_cell(name), {sizes_text(one.domain, " x "), true}, {sizes_text(one.degree, ", "), true}};
    for (const std::int64_t bound :
         {std::int64_t{one.grading}, std::int64_t{one.level}, one.elements, one.active_nodes}) {
      cells.push_back(number_cell(bound));
    }
  }
  add_table(parent, table);
}

void add_claim_tables(HtmlNode parent, std::span<const LedgerRecord> records) {
  HtmlTable table{
      "claims-table",
      "Claims",
      {"claim", "source", "status", "result", "distinct meshes", "sequences", "alone", "trials with the hypothesis met",
       "of all trials", "times met", "holds", "violated", "not applicable", "undecided"},
      {}};
  for (const LedgerRecord& record : records) table.rows.push_back(row(record));
  add_paragraph(
      parent,
      "How often each claim was tried, on how many distinct meshes, in how many trials its hypothesis was met, "
      "and how the trials came out:");
  add_table(parent, table);
  BoundsByName bounds;
  for (const LedgerRecord& record : records) bounds.emplace_back(record.claim, record.bounds);
  add_bounds_table(parent, bounds);
  add_html(parent, "h3", {}, "Statements");
  HtmlNode list = add_html(parent, "dl");
  for (const LedgerRecord& record : records) add_statement(list, record.claim);
  HtmlNode trials = add_details(parent, "Where decided trials came from");
  add_tally_tables(trials, "claim-biases", "Decided trials by what their case was drawn to provoke", records,
                   &LedgerRecord::biases);
  add_tally_tables(trials, "claim-features", "Decided trials by what their mesh has", records, &LedgerRecord::features);
}

}  // namespace asts
