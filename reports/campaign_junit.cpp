#include "reports/campaign_junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>
#include <vector>

#include "lib/mesh/case_file.hpp"
#include "properties/claims/claim.hpp"
#include "reports/campaign_text.hpp"
#include "reports/clean_text.hpp"

namespace asts {

namespace {

using Findings = std::vector<const CampaignFinding*>;

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(clean_text(value).c_str());
}

/// A line end in an attribute would not come back, and a list shows one line.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string full_text(const CampaignFinding& finding) {
  const std::string file = finding.file.empty() ? "" : fmt::format("\n# {}", finding.file);
  const std::string content = finding.content ? write_case(*finding.content) : "";
  return fmt::format("# {}{}\n{}{}", finding_name(finding), file, content, finding_text(finding));
}

std::string full_text(const Findings& findings) {
  std::string text;
  for (const CampaignFinding* finding : findings) text += full_text(*finding) + "\n";
  return text;
}

pugi::xml_node add_case(pugi::xml_node suite, const std::string& class_name, const std::string& name) {
  pugi::xml_node node = suite.append_child("testcase");
  set(node, "classname", "asts." + class_name);
  set(node, "name", name);
  return node;
}

void add_outcome(pugi::xml_node node, const char* outcome, const std::string& type, const std::string& message,
                 const std::string& text) {
  pugi::xml_node child = node.append_child(outcome);
  if (!type.empty()) set(child, "type", type);
  set(child, "message", one_line(message));
  if (!text.empty()) child.text().set(clean_text(text).c_str());
}

/// The worst of a claim's findings decides: a death, then a violation that is not expected.
void add_findings(pugi::xml_node node, const Findings& findings) {
  const auto death = std::find_if(findings.begin(), findings.end(), [](const auto* one) { return is_death(*one); });
  const auto failure = std::find_if(findings.begin(), findings.end(), [](const auto* one) { return !one->expected; });
  if (failure == findings.end()) {
    if (findings.empty()) return;
    const std::string text = "violated as expected: the claim is refuted\n\n" + full_text(findings);
    node.append_child("system-out").text().set(clean_text(text).c_str());
    return;
  }
  const CampaignFinding& worst = death != findings.end() ? **death : **failure;
  add_outcome(node, death != findings.end() ? "error" : "failure", worst.kind, finding_name(worst),
              full_text(findings));
}

Findings findings_of(const CampaignSummary& summary, const std::string& claim) {
  Findings findings;
  for (const CampaignFinding& finding : summary.findings) {
    if (finding.claim == claim) findings.push_back(&finding);
  }
  return findings;
}

void add_claim(pugi::xml_node suite, const CampaignSummary& summary, const LedgerRecord& record) {
  const Claim* claim = find_claim(record.claim);
  pugi::xml_node node = add_case(suite, claim != nullptr ? kind_name(claim->kind) : "claim", record.claim);
  const Findings findings = findings_of(summary, record.claim);
  add_findings(node, findings);
  if (!findings.empty() || record.result() != LedgerResult::undecided) return;
  add_outcome(node, "skipped", "", fmt::format("the hypothesis was met in none of {} trials", record.trials()), "");
}

/// `suite` has properties first, then test cases.
void add_properties(pugi::xml_node suite, const CampaignSummary& summary) {
  pugi::xml_node properties = suite.append_child("properties");
  const auto add = [&](const char* name, const std::string& value) {
    pugi::xml_node property = properties.append_child("property");
    set(property, "name", name);
    set(property, "value", value);
  };
  add("version", summary.version);
  add("seed", std::to_string(summary.seed));
  add("cases", std::to_string(summary.cases));
  add("meshes", std::to_string(summary.meshes));
  add("distinct", std::to_string(summary.distinct));
}

void add_cases(pugi::xml_node suite, const CampaignSummary& summary, std::span<const HealthProblem> problems) {
  for (const LedgerRecord& record : summary.records) add_claim(suite, summary, record);
  const Findings others = findings_of(summary, "");
  if (!others.empty()) add_findings(add_case(suite, "campaign", "outside-of-claims"), others);
  for (const HealthProblem& problem : problems) {
    const std::string subject = problem.subject.empty() ? "" : " " + problem.subject;
    add_outcome(add_case(suite, "health", problem.check + subject), "error", problem.check, problem.says, "");
  }
}

std::size_t count_with(pugi::xml_node suite, const char* outcome) {
  const auto cases = suite.children("testcase");
  return static_cast<std::size_t>(
      std::count_if(cases.begin(), cases.end(), [&](const auto& one) { return one.child(outcome); }));
}

}  // namespace

std::string campaign_junit(const CampaignSummary& summary, std::span<const HealthProblem> problems) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version").set_value("1.0");
  declaration.append_attribute("encoding").set_value("UTF-8");
  pugi::xml_node suite = document.append_child("testsuites").append_child("testsuite");
  set(suite, "name", "asts campaign");
  for (const char* count : {"tests", "failures", "errors", "skipped"}) suite.append_attribute(count);
  add_properties(suite, summary);
  add_cases(suite, summary, problems);
  const auto cases = suite.children("testcase");
  suite.attribute("tests").set_value(static_cast<unsigned>(std::distance(cases.begin(), cases.end())));
  suite.attribute("failures").set_value(static_cast<unsigned>(count_with(suite, "failure")));
  suite.attribute("errors").set_value(static_cast<unsigned>(count_with(suite, "error")));
  suite.attribute("skipped").set_value(static_cast<unsigned>(count_with(suite, "skipped")));
  std::ostringstream text;
  document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
  return text.str();
}

}  // namespace asts
