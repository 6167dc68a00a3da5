#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "reports/claims_report.hpp"
#include "reports/html/check_sections.hpp"
#include "reports/html/claim_table.hpp"
#include "reports/html/histogram.hpp"

namespace asts {

namespace {

void raise(LedgerBounds& bounds, const Case& content, const CheckRecord::Figures& mesh) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    bounds.domain[axis] = std::max(bounds.domain[axis], content.domain[axis]);
    bounds.degree[axis] = std::max(bounds.degree[axis], content.degree[axis]);
  }
  bounds.grading = std::max(bounds.grading, content.grading);
  bounds.level = std::max(bounds.level, mesh.max_level.value_or(0));
  bounds.elements = std::max(bounds.elements, mesh.elements);
  bounds.active_nodes = std::max(bounds.active_nodes, mesh.active_nodes);
}

void count(StatementCounts& counts, const Verdict& verdict, std::int64_t met, const Case& content,
           const CheckRecord& record) {
  ++counts.trials[verdict.outcome];
  counts.met += met;
  counts.trials_met += met > 0 ? 1 : 0;
  const bool decided = verdict.outcome == Outcome::holds || verdict.outcome == Outcome::violated;
  if (decided && record.mesh) raise(counts.bounds, content, *record.mesh);
}

const char* source_of(const Statement& statement) {
  return statement.claim != nullptr ? statement.claim->source : statement.property->source;
}

std::vector<HtmlCell> row(const StatementCounts& counts) {
  const Statement& statement = counts.statement;
  const bool claim = statement.claim != nullptr;
  std::vector<HtmlCell> cells{text_cell(statement.id(), statement_id(statement.id())), text_cell(source_of(statement)),
                              text_cell(claim ? status_name(*statement.claim) : "property")};
  std::int64_t trials = 0;
  for (const auto& [outcome, number] : counts.trials) {
    trials += number;
    cells.push_back(number_cell(number));
  }
  cells.push_back(claim ? number_cell(counts.trials_met) : text_cell("-"));
  cells.push_back(claim ? HtmlCell{percent(counts.trials_met, trials), true} : text_cell("-"));
  cells.push_back(claim ? number_cell(counts.met) : text_cell("-"));
  return cells;
}

}  // namespace

std::vector<StatementCounts> counts_of(const CheckRun& run) {
  std::vector<StatementCounts> result;
  for (const Property* property : run.properties) result.emplace_back().statement.property = property;
  for (const Claim* claim : run.claims) result.emplace_back().statement.claim = claim;
  for (const CheckRun::Mesh& mesh : run.meshes) {
    const Case& content = run.cases[mesh.place].content;
    for (StatementCounts& counts : result) {
      for (const auto& entry : mesh.record.entries) {
        if (entry.property == counts.statement.property) count(counts, entry.verdict, 0, content, mesh.record);
      }
      for (const auto& entry : mesh.record.claims) {
        if (entry.claim != counts.statement.claim) continue;
        count(counts, entry.trial.verdict, entry.trial.met, content, mesh.record);
      }
    }
  }
  return result;
}

void add_statements(HtmlNode parent, const CheckRun& run) {
  HtmlNode section = add_section(parent, 2, "claims", "Statements");
  HtmlTable table{"claims-table",
                  "Properties and claims",
                  {"statement", "source", "status", "holds", "violated", "not applicable", "undecided",
                   "meshes with the hypothesis met", "of all meshes", "times met"},
                  {}};
  for (const StatementCounts& counts : counts_of(run)) table.rows.push_back(row(counts));
  add_paragraph(section,
                "How the verdicts on the meshes came out, and in how many of them a claim's hypothesis was met:");
  add_table(section, table);
  BoundsByName bounds;
  for (const StatementCounts& counts : counts_of(run)) bounds.emplace_back(counts.statement.id(), counts.bounds);
  add_bounds_table(section, bounds);
  add_html(section, "h3", {}, "In full");
  HtmlNode list = add_html(section, "dl");
  for (const Property* property : run.properties) add_statement(list, property->id);
  for (const Claim* claim : run.claims) add_statement(list, claim->id);
}

void add_sizes(HtmlNode parent, const CheckRun& run) {
  HtmlNode section = add_section(parent, 2, "generated", "What was checked");
  std::map<std::int64_t, std::int64_t> levels;
  std::map<std::uint64_t, std::int64_t> sizes;
  for (const CheckRun::Mesh& mesh : run.meshes) {
    if (!mesh.record.mesh) continue;
    ++levels[mesh.record.mesh->max_level.value_or(-1)];
    ++sizes[std::bit_ceil(static_cast<std::uint64_t>(mesh.record.mesh->elements))];
  }
  std::vector<std::pair<std::string, std::int64_t>> by_level;
  for (const auto& [level, number] : levels) by_level.emplace_back(level < 0 ? "none" : std::to_string(level), number);
  add_histogram(section, "checked-levels", "Meshes by their highest level", "level", "meshes", by_level);
  std::vector<std::pair<std::string, std::int64_t>> by_size;
  for (const auto& [size, number] : sizes) by_size.emplace_back("up to " + std::to_string(size), number);
  add_histogram(section, "checked-sizes", "Meshes by size", "elements", "meshes", by_size);
  HtmlTable table{"cases-table", "The cases", {"case", "file", "domain", "p", "m", "steps", "boxes"}, {}};
  for (const CheckRun::CheckedCase& one : run.cases) {
    table.rows.push_back({text_cell(one.name),
                          text_cell(one.file),
                          {sizes_text(one.content.domain, " x "), true},
                          {sizes_text(one.content.degree, ", "), true},
                          number_cell(one.content.grading),
                          number_cell(static_cast<long long>(one.content.steps.size())),
                          number_cell(static_cast<long long>(one.content.elements.size()))});
  }
  add_table(section, table);
}

}  // namespace asts
