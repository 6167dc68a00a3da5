#include "reports/campaign_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "reports/ledger_report.hpp"
#include "reports/minimize_report.hpp"

namespace asts {

namespace {

constexpr const char* kRow = "{:<32} {:<9} {:<12} {:>9} {:>9} {:>5} {:>11} {:>12} {:>9} {:>9}\n";

std::string counts(const CampaignSummary& summary) {
  return fmt::format(
      "asts {}: {} {}, seed {}\n{} cases, {} of them sequences of refine steps\n"
      "{} meshes, {} distinct, {} of these initial meshes\n",
      summary.version, summary.claims.size(), summary.claims.size() == 1 ? "claim" : "claims", summary.seed,
      summary.cases, summary.sequences, summary.meshes, summary.distinct, summary.trivial);
}

std::string deaths(const CampaignSummary& summary) {
  return summary.deaths == 0 ? "" : fmt::format("the code under test did not come back {} times\n", summary.deaths);
}

std::string row(const LedgerRecord& record) {
  return fmt::format(fmt::runtime(kRow), record.claim, status_of(record), result_name(record.result()), record.meshes,
                     record.sequences, record.alone, record.trials_met, record.met, record.violated, record.undecided);
}

std::string table(const CampaignSummary& summary) {
  std::string result = fmt::format(fmt::runtime(kRow), "claim", "status", "result", "meshes", "sequences", "alone",
                                   "trials-met", "met", "violated", "undecided");
  for (const LedgerRecord& record : summary.records) result += row(record);
  return result;
}

std::string size_line(const CampaignFinding& finding) {
  if (!finding.minimized) return finding.content ? "as drawn, not minimized\n" : "";
  return fmt::format("{}, {} after {} evaluations\n", size_text(*finding.content, finding.minimized->size),
                     guarantee_name(finding.minimized->guarantee), finding.minimized->evaluations);
}

std::string origin(const CampaignFinding& finding) {
  if (!finding.number) return "tried without a case\n";
  if (*finding.number < 0) return fmt::format("first met in stored case {}\n", -*finding.number);
  return fmt::format("first met in case {}, step {}\n", *finding.number, finding.step);
}

std::string validity(const CampaignFinding& finding) {
  if (!finding.valid) return "";
  const std::string why = finding.validation.empty() ? "" : ": " + finding.validation;
  return fmt::format("the literal code says: {}{}\n", *finding.valid ? "valid" : "NOT VALID", why);
}

/// Each line moved to the right.
std::string indented(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, end);
    result += (line == "\n" ? "" : "    ") + std::string(line);
    text.remove_prefix(end);
  }
  if (!result.empty() && result.back() != '\n') result += '\n';
  return result;
}

std::string findings(const CampaignSummary& summary) {
  const auto unexpected = std::count_if(summary.findings.begin(), summary.findings.end(),
                                        [](const CampaignFinding& finding) { return !finding.expected; });
  std::string result = fmt::format("\nfindings: {}, {} of them unexpected\n", summary.findings.size(), unexpected);
  for (const CampaignFinding& finding : summary.findings) {
    result += fmt::format("\n{}{}{}{}\n", finding.expected ? "" : "UNEXPECTED ", finding_name(finding),
                          finding.file.empty() ? "" : ": ", finding.file);
    result += indented(finding_text(finding));
  }
  return result;
}

std::string health(std::span<const HealthProblem> problems) {
  if (problems.empty()) return "\nhealth: good\n";
  std::string result = fmt::format("\nhealth: {} {}\n", problems.size(), problems.size() == 1 ? "problem" : "problems");
  for (const HealthProblem& problem : problems) {
    result += fmt::format("    {}{}{}: {}\n", problem.check, problem.subject.empty() ? "" : " ", problem.subject,
                          problem.says);
  }
  return result;
}

}  // namespace

bool is_death(const CampaignFinding& finding) {
  return std::find(kDeathKinds.begin(), kDeathKinds.end(), finding.kind) != kDeathKinds.end();
}

std::string finding_name(const CampaignFinding& finding) {
  return (finding.claim.empty() ? "while no claim was tried" : finding.claim) + ": " + finding.kind;
}

std::string finding_text(const CampaignFinding& finding) {
  std::string says = finding.says;
  if (!says.empty() && says.back() != '\n') says += '\n';
  return size_line(finding) + origin(finding) + validity(finding) + says;
}

std::string campaign_text(const CampaignSummary& summary, std::span<const HealthProblem> problems) {
  return counts(summary) + deaths(summary) + "\n" + table(summary) + findings(summary) + health(problems);
}

}  // namespace asts
