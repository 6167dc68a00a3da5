#include <fmt/format.h>

#include <set>

#include "lib/mesh/case_prefix.hpp"
#include "reports/html/check_sections.hpp"
#include "reports/html/claim_table.hpp"
#include "reports/html/shown_mesh.hpp"
#include "reports/html/witness_numbers.hpp"
#include "reports/ledger_report.hpp"

namespace asts {

namespace {

/// A verdict on one mesh.
struct Decided {
  Statement statement;
  const Verdict* verdict;
  std::int64_t met = 0;
};

std::vector<Decided> verdicts_of(const CheckRecord& record) {
  std::vector<Decided> result;
  for (const auto& entry : record.entries) result.push_back({{nullptr, entry.property}, &entry.verdict, 0});
  for (const auto& entry : record.claims) {
    result.push_back({{entry.claim, nullptr}, &entry.trial.verdict, entry.trial.met});
  }
  return result;
}

/// A case violates a statement on a mesh.
struct Violation {
  std::int64_t step;
  Decided decided;
};

/// A case violates a statement: its first mesh that does, and the verdicts on all that do, in their order.
struct CheckFinding {
  const CheckRun::Mesh* mesh;
  Decided decided;  ///< the first of the violations
  std::vector<Violation> violations;
};

std::vector<CheckFinding> findings_of(const CheckRun& run) {
  std::vector<CheckFinding> findings;
  std::map<std::pair<std::size_t, std::string>, std::size_t> places;
  for (const CheckRun::Mesh& mesh : run.meshes) {
    for (const Decided& decided : verdicts_of(mesh.record)) {
      if (decided.verdict->outcome != Outcome::violated) continue;
      const auto [place, fresh] = places.try_emplace({mesh.place, decided.statement.id()}, findings.size());
      if (fresh) findings.push_back({&mesh, decided, {}});
      findings[place->second].violations.push_back({mesh.record.step, decided});
    }
  }
  return findings;
}

std::string finding_id(std::size_t place) { return fmt::format("finding-{}", place + 1); }

std::string steps_text(const std::vector<Violation>& violations) {
  std::string result;
  for (const Violation& one : violations) result += (result.empty() ? "" : ", ") + std::to_string(one.step);
  return result;
}

void add_figures(HtmlNode parent, const CheckRun& run, const CheckFinding& finding) {
  const CheckRun::CheckedCase& checked = run.cases[finding.mesh->place];
  std::vector<std::pair<std::string, std::string>> facts{
      {"case", checked.name},
      {"first violated after step", std::to_string(finding.mesh->record.step)},
      {"violated after steps", steps_text(finding.violations)}};
  if (finding.decided.verdict->witness) facts.emplace_back("kind", kind_of(*finding.decided.verdict->witness));
  if (finding.mesh->record.mesh) facts.emplace_back("elements", std::to_string(finding.mesh->record.mesh->elements));
  if (finding.decided.statement.claim != nullptr) {
    facts.emplace_back("times the hypothesis is met in it", std::to_string(finding.decided.met));
  }
  facts.emplace_back("how sure its size is", "as given, not minimized: asts minimize makes it smaller");
  add_facts(parent, facts);
}

/// The witnesses on the meshes that follow, which are not drawn.
void add_later_witnesses(HtmlNode parent, const std::string& id, const CheckFinding& finding) {
  if (finding.violations.size() < 2) return;
  HtmlNode details = add_details(parent, "The witnesses on the later meshes");
  for (std::size_t i = 1; i < finding.violations.size(); ++i) {
    const Violation& one = finding.violations[i];
    add_paragraph(details, fmt::format("After step {}:", one.step));
    add_lines(details, violation_text(*one.decided.verdict));
    const std::optional<Witness>& witness = one.decided.verdict->witness;
    if (witness) add_witness_numbers(details, fmt::format("{}-witness-{}", id, one.step), *witness);
  }
}

void add_replay(HtmlNode parent, const CheckRun& run, const CheckFinding& finding) {
  const Statement& statement = finding.decided.statement;
  const std::string option = fmt::format("--{} {}", statement.claim != nullptr ? "claim" : "property", statement.id());
  const std::string& file = run.cases[finding.mesh->place].file;
  add_html(parent, "h4", {}, "Replay");
  add_paragraph(parent,
                "In the run directory, to decide it again, to draw the last mesh and to make the case smaller:");
  add_command(parent, fmt::format("asts check {} {}", option, file));
  add_command(parent, fmt::format("asts draw {} --out pictures {}", option, file));
  add_command(parent, fmt::format("asts minimize {} {}", option, file));
}

void add_finding(HtmlNode parent, const CheckRun& run, std::size_t place, const CheckFinding& finding,
                 MeshGallery& gallery) {
  const Decided& decided = finding.decided;
  const std::string id = finding_id(place);
  const CheckRun::CheckedCase& checked = run.cases[finding.mesh->place];
  HtmlNode section = add_section(parent, 3, id, fmt::format("{}: {}", decided.statement.id(), checked.name));
  section.append_attribute("class") = "finding unexpected";
  HtmlNode list = add_html(section, "p", {}, "It violates ");
  add_html(list, "a", {{"href", "#" + statement_id(decided.statement.id())}}, decided.statement.id());
  const bool claim = decided.statement.claim != nullptr;
  add_words(list,
            fmt::format(" ({}): {}.", claim ? decided.statement.claim->source : decided.statement.property->source,
                        claim ? decided.statement.claim->statement : decided.statement.property->statement));
  add_figures(section, run, finding);
  const Case content = case_prefix(checked.content, static_cast<std::size_t>(finding.mesh->record.step));
  const Witness* witness = decided.verdict->witness ? &*decided.verdict->witness : nullptr;
  gallery.add(section, {&content, witness, fmt::format("{} after step {}", checked.name, finding.mesh->record.step)});
  if (witness != nullptr) add_witness_numbers(section, id + "-witness", *witness);
  add_html(section, "h4", {}, "In words");
  add_lines(section, violation_text(*decided.verdict));
  add_later_witnesses(section, id, finding);
  add_replay(section, run, finding);
}

std::vector<HtmlCell> row(const CheckRun& run, const CheckRun::Mesh& mesh) {
  std::vector<HtmlCell> cells{text_cell(run.cases[mesh.place].name), number_cell(mesh.record.step)};
  if (const auto& figures = mesh.record.mesh) {
    cells.push_back(number_cell(figures->elements));
    cells.push_back(number_cell(figures->new_elements));
    cells.push_back(figures->max_level ? number_cell(*figures->max_level) : text_cell("none"));
    cells.push_back(number_cell(figures->active_nodes));
  } else {
    cells.insert(cells.end(), 4, text_cell("-"));
  }
  for (const Decided& decided : verdicts_of(mesh.record)) {
    const std::string met = decided.met > 0 ? fmt::format(", met {}", decided.met) : "";
    const std::string& reason = decided.verdict->reason;
    cells.push_back(text_cell(outcome_name(decided.verdict->outcome) + met + (reason.empty() ? "" : ": " + reason)));
  }
  return cells;
}

}  // namespace

void add_check_findings(HtmlNode parent, const CheckRun& run, MeshGallery& gallery) {
  HtmlNode section = add_section(parent, 2, "findings", "Findings");
  const std::vector<CheckFinding> findings = findings_of(run);
  if (findings.empty()) add_paragraph(section, "Nothing is violated.");
  for (std::size_t i = 0; i < findings.size(); ++i) add_finding(section, run, i, findings[i], gallery);
}

void add_meshes(HtmlNode parent, const CheckRun& run, MeshGallery& gallery) {
  HtmlNode section = add_section(parent, 2, "meshes", "Meshes");
  HtmlTable table{"meshes-table",
                  "All meshes and the verdicts on them",
                  {"case", "step", "elements", "new", "level", "active nodes"},
                  {}};
  for (const Property* property : run.properties) table.columns.emplace_back(property->id);
  for (const Claim* claim : run.claims) table.columns.emplace_back(claim->id);
  for (const CheckRun::Mesh& mesh : run.meshes) table.rows.push_back(row(run, mesh));
  add_table(section, table);
  std::set<std::size_t> drawn;
  for (const CheckFinding& finding : findings_of(run)) drawn.insert(finding.mesh->place);
  for (std::size_t i = 0; i < run.cases.size(); ++i) {
    if (drawn.contains(i)) continue;
    const CheckRun::CheckedCase& checked = run.cases[i];
    add_html(section, "h3", {}, checked.name);
    gallery.add(section, {&checked.content, nullptr, "the last mesh of " + checked.name});
  }
}

}  // namespace asts
