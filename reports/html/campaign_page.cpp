#include "reports/html/campaign_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/html/campaign_sections.hpp"
#include "reports/html/claim_table.hpp"
#include "reports/html/page_frame.hpp"

namespace asts {

namespace {

std::int64_t unexpected(const CampaignSummary& summary) {
  return std::count_if(summary.findings.begin(), summary.findings.end(),
                       [](const CampaignFinding& finding) { return !finding.expected; });
}

std::string lead(const CampaignSummary& summary) {
  return fmt::format("{} tried on {} with seed {} by asts {}: {} distinct of {} meshes.",
                     counted(static_cast<long long>(summary.claims.size()), "claim"), counted(summary.cases, "case"),
                     summary.seed, summary.version, summary.distinct, summary.meshes);
}

/// One line that says whether all is well.
void add_verdict(HtmlNode parent, const CampaignRecords& records) {
  const CampaignSummary& summary = records.summary;
  const std::int64_t bad = unexpected(summary);
  const bool good = bad == 0 && records.health.empty();
  add_html(
      parent, "p", {{"class", good ? "good" : "bad"}},
      fmt::format("{}, {} of them unexpected. Health: {}.",
                  counted(static_cast<long long>(summary.findings.size()), "finding"), bad,
                  records.health.empty() ? "good" : counted(static_cast<long long>(records.health.size()), "problem")));
}

void add_problems(HtmlNode parent, const CampaignRecords& records) {
  if (!records.health.empty()) {
    HtmlTable table{"health-table", "Why this run says less than it seems to", {"check", "about", "what it says"}, {}};
    for (const HealthProblem& problem : records.health) {
      table.rows.push_back({text_cell(problem.check), text_cell(problem.subject), text_cell(problem.says)});
    }
    add_table(parent, table);
  }
  if (records.differences.empty()) return;
  add_html(parent, "p", {{"class", "bad"}},
           "Files of the run directory do not say what its records say. The numbers on this page are those of the "
           "records (units.jsonl, findings.jsonl):");
  HtmlNode list = add_html(parent, "ul");
  for (const std::string& difference : records.differences) add_html(list, "li", {}, difference);
}

void add_summary(HtmlNode main, const CampaignRecords& records) {
  const CampaignSummary& summary = records.summary;
  HtmlNode section = add_section(main, 2, "summary", "Summary");
  add_verdict(section, records);
  add_problems(section, records);
  const std::string asked =
      records.cases_asked == 0 ? "as many as fit into the time given" : std::to_string(records.cases_asked);
  add_facts(section, {{"version", summary.version},
                      {"seed", std::to_string(summary.seed)},
                      {"cases asked for", asked},
                      {"cases made", std::to_string(summary.cases)},
                      {"of these sequences of refine steps", std::to_string(summary.sequences)},
                      {"meshes", std::to_string(summary.meshes)},
                      {"of these distinct", std::to_string(summary.distinct)},
                      {"of the distinct ones initial meshes", std::to_string(summary.trivial)},
                      {"times the code under test did not come back", std::to_string(summary.deaths)},
                      {"findings", std::to_string(summary.findings.size())},
                      {"of these unexpected", std::to_string(unexpected(summary))},
                      {"findings not worked out", std::to_string(records.findings_open)}});
  if (records.summary.cases < records.cases_asked || records.findings_open > 0) {
    add_paragraph(section, "The campaign is not complete: --resume goes on with it.");
  }
  add_finding_list(section, records);
}

void add_claims(HtmlNode main, const CampaignRecords& records) {
  HtmlNode section = add_section(main, 2, "claims", "Claims");
  add_paragraph(
      section,
      "A claim is a statement of the paper, or a repaired form of one that is false as printed. Its status is "
      "refuted when a counterexample is known. Where the hypothesis was never met the run says nothing: the "
      "result is undecided.");
  if (records.named) add_paragraph(section, "The claims were named, so that each was expected to hold in this run.");
  add_claim_tables(section, records.summary.records);
}

/// The command that makes this run again.
std::string command_of(const CampaignRecords& records) {
  std::string command = "asts campaign";
  if (records.named) {
    for (const std::string& claim : records.summary.claims) command += " --claim " + claim;
  }
  return command + fmt::format(" --seed {} --cases {} --out DIR", records.summary.seed, records.summary.cases);
}

void add_about(HtmlNode main, const CampaignRecords& records, const std::string& version) {
  HtmlNode section = add_section(main, 2, "about", "Versions and seed");
  add_facts(section, {{"version that made the run", records.summary.version},
                      {"seed", std::to_string(records.summary.seed)},
                      {"evaluations to minimize one violation, at most", std::to_string(records.minimize_budget)},
                      {"stored cases decided first", std::to_string(records.stored.size())},
                      {"version that wrote this page", version}});
  if (!records.stored.empty()) {
    HtmlNode list = add_html(add_details(section, "Stored cases"), "ul");
    for (const std::string& name : records.stored) add_html(list, "li", {}, name);
  }
  add_paragraph(section, "The same version, claims, seed and number of cases give the same run:");
  add_command(section, command_of(records));
  if (!records.stored.empty()) add_paragraph(section, "and --replay with the collection of the stored cases.");
  add_paragraph(section, "The literal code decides all witnesses again with");
  add_command(section, "asts validate findings.jsonl");
}

}  // namespace

std::string campaign_page(const CampaignRecords& records, const std::string& version) {
  PageFrame frame("Report of a campaign", lead(records.summary),
                  {{"summary", "Summary"},
                   {"claims", "Claims"},
                   {"findings", "Findings"},
                   {"generated", "What was generated"},
                   {"performance", "Performance"},
                   {"about", "Versions and seed"}});
  add_summary(frame.main(), records);
  add_claims(frame.main(), records);
  add_findings(frame.main(), records);
  add_generated(frame.main(), records.summary);
  add_performance(frame.main(), records);
  add_about(frame.main(), records, version);
  return std::move(frame).text();
}

}  // namespace asts
