#include <fmt/format.h>

#include <algorithm>

#include "lib/mesh/case_file.hpp"
#include "reports/campaign_text.hpp"
#include "reports/html/campaign_sections.hpp"
#include "reports/html/claim_table.hpp"
#include "reports/html/shown_mesh.hpp"
#include "reports/html/witness_numbers.hpp"
#include "reports/minimize_report.hpp"

namespace asts {

namespace {

using Details = CampaignRecords::Details;

std::string finding_id(std::size_t place) { return fmt::format("finding-{}", place + 1); }

std::string origin_text(const std::optional<std::int64_t>& number, std::int64_t step) {
  if (!number) return "without a case";
  if (*number < 0) return fmt::format("stored case {}", -*number);
  return step < 0 ? fmt::format("case {}, while it was made", *number) : fmt::format("case {}, step {}", *number, step);
}

/// What each way to be as small as it is means.
std::string guarantee_words(const std::string& guarantee) {
  if (guarantee == "1-minimal") return "1-minimal: no pass of the minimizer makes it smaller";
  if (guarantee == "budget") return "the smallest so far: the budget of evaluations ended";
  if (guarantee == "interrupted") return "the smallest so far: the minimizer was interrupted";
  return guarantee;
}

std::string certainty(const CampaignFinding& finding) {
  if (finding.minimized) return guarantee_words(guarantee_name(finding.minimized->guarantee));
  return finding.content ? "as drawn, not minimized" : "there is no case";
}

std::string validity(const CampaignFinding& finding) {
  if (!finding.valid) return "there is no witness to decide";
  return *finding.valid ? "valid" : "NOT VALID";
}

void add_figures(HtmlNode parent, const CampaignFinding& finding, const Details& details) {
  std::vector<std::pair<std::string, std::string>> facts;
  facts.emplace_back("kind", finding.kind);
  facts.emplace_back("expected", finding.expected ? "yes: the claim is refuted already" : "no");
  if (finding.minimized) facts.emplace_back("size", size_text(*finding.content, finding.minimized->size));
  if (details.elements) facts.emplace_back("elements", std::to_string(*details.elements));
  facts.emplace_back("how sure that is", certainty(finding));
  if (finding.minimized) facts.emplace_back("evaluations", std::to_string(finding.minimized->evaluations));
  if (details.met) facts.emplace_back("times the hypothesis is met in it", std::to_string(*details.met));
  facts.emplace_back("first met in", origin_text(finding.number, finding.step));
  facts.emplace_back("the literal code says", validity(finding));
  if (!finding.file.empty()) facts.emplace_back("file", finding.file);
  add_facts(parent, facts);
}

void add_origins(HtmlNode parent, const std::string& id, const Details& details) {
  if (details.origins.size() < 2) return;
  HtmlTable table{id + "-origins",
                  "Minimized to this from",
                  {"case", "evaluations", "of these in the last run", "how it ended"},
                  {}};
  for (const CampaignRecords::Origin& origin : details.origins) {
    table.rows.push_back({text_cell(origin_text(origin.number, origin.step)),
                          origin.evaluations ? number_cell(*origin.evaluations) : text_cell("-"),
                          number_cell(origin.last_evaluations), text_cell(origin.guarantee)});
  }
  add_table(parent, table);
}

void add_passes(HtmlNode parent, const std::string& id, const Details& details) {
  if (details.last_run.empty()) return;
  HtmlTable table{
      id + "-passes", "The last run of the minimizer's passes", {"pass", "evaluations", "made it smaller"}, {}};
  for (const Details::Pass& pass : details.last_run) {
    table.rows.push_back(
        {text_cell(pass.name), number_cell(pass.evaluations), text_cell(pass.accepted ? "yes" : "no")});
  }
  add_table(add_details(parent, "What was tried last to make it smaller"), table);
}

void add_others(HtmlNode parent, const Details& details) {
  for (const auto& [kind, content] : details.others) {
    HtmlNode other = add_details(parent, "Also violated, met on the way: " + kind);
    add_lines(other, content);
  }
}

void add_replay(HtmlNode parent, const CampaignFinding& finding) {
  if (!finding.content || finding.file.empty()) {
    if (!finding.claim.empty()) add_command(parent, fmt::format("asts ledger --claim {} --cases 0", finding.claim));
    return;
  }
  add_paragraph(parent, "In the run directory, to decide it again and to draw it:");
  const std::string claim = finding.claim.empty() ? "" : " --claim " + finding.claim;
  add_command(parent, fmt::format("asts check --final{} {}", claim, finding.file));
  add_command(parent, fmt::format("asts draw{} --out pictures {}", claim, finding.file));
}

/// Code that did not come back from a case may not come back from drawing it either.
void add_pictures(HtmlNode parent, const CampaignFinding& finding, const Details& details, MeshGallery& gallery) {
  if (!finding.content) return;
  if (is_death(finding)) {
    add_paragraph(parent, "It is not drawn here: the code under test did not come back from this case.");
    return;
  }
  const Witness* witness = details.witness ? &*details.witness : nullptr;
  gallery.add(parent, {&*finding.content, witness, finding_name(finding)});
}

void add_finding(HtmlNode parent, std::size_t place, const CampaignFinding& finding, const Details& details,
                 MeshGallery& gallery) {
  const std::string id = finding_id(place);
  HtmlNode section = add_section(parent, 3, id, finding_name(finding));
  section.append_attribute("class") = finding.expected ? "finding" : "finding unexpected";
  if (!finding.claim.empty()) {
    const Claim* claim = find_claim(finding.claim);
    HtmlNode statement =
        add_paragraph(section, claim == nullptr ? "" : fmt::format("{}: {} (", claim->source, claim->statement));
    add_html(statement, "a", {{"href", "#" + statement_id(finding.claim)}}, finding.claim);
    add_words(statement, claim == nullptr ? "" : ")");
  }
  add_figures(section, finding, details);
  add_pictures(section, finding, details, gallery);
  if (details.witness) add_witness_numbers(section, id + "-witness", *details.witness);
  add_html(section, "h4", {}, "In words");
  add_lines(section, finding.says.empty() ? "-" : finding.says);
  if (!finding.validation.empty()) add_paragraph(section, "The literal code: " + finding.validation);
  add_html(section, "h4", {}, "Replay");
  add_replay(section, finding);
  if (finding.content) add_lines(section, write_case(*finding.content));
  add_origins(section, id, details);
  add_passes(section, id, details);
  add_others(section, details);
}

}  // namespace

void add_finding_list(HtmlNode parent, const CampaignRecords& records) {
  const auto& findings = records.summary.findings;
  if (findings.empty()) return;
  HtmlTable table{"findings-table", "Findings", {"what", "expected", "size", "how sure that is"}, {}};
  for (const bool expected : {false, true}) {
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const CampaignFinding& one = findings[i];
      if (one.expected != expected) continue;
      table.rows.push_back({text_cell(finding_name(one), finding_id(i)), text_cell(one.expected ? "yes" : "no"),
                            text_cell(one.minimized ? size_text(*one.content, one.minimized->size) : "-"),
                            text_cell(certainty(one))});
    }
  }
  add_table(parent, table);
}

void add_findings(HtmlNode parent, const CampaignRecords& records) {
  HtmlNode section = add_section(parent, 2, "findings", "Findings");
  const auto& findings = records.summary.findings;
  if (findings.empty()) add_paragraph(section, "Nothing was found.");
  MeshGallery gallery;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    add_finding(section, i, findings[i], records.details.at(i), gallery);
  }
}

}  // namespace asts
