#include "reports/html/check_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/html/check_sections.hpp"
#include "reports/html/page_frame.hpp"

namespace asts {

namespace {

std::string lead(const CheckRun& run) {
  return fmt::format("{} decided by asts {}: {}.", counted(static_cast<long long>(run.cases.size()), "case"),
                     run.version, counted(static_cast<long long>(run.meshes.size()), "mesh", "meshes"));
}

std::int64_t count_of(const CheckRun& run, Outcome outcome) {
  std::int64_t count = 0;
  for (const StatementCounts& counts : counts_of(run)) count += counts.trials.at(outcome);
  return count;
}

void add_summary(HtmlNode main, const CheckRun& run) {
  HtmlNode section = add_section(main, 2, "summary", "Summary");
  const std::int64_t violated = count_of(run, Outcome::violated);
  const std::int64_t undecided = count_of(run, Outcome::undecided);
  const bool complete = run.meshes.size() == run.asked();
  const bool good = violated == 0 && undecided == 0 && complete;
  add_html(section, "p", {{"class", good ? "good" : "bad"}},
           fmt::format("{} verdicts are violated, {} undecided.{}", violated, undecided,
                       complete ? "" : " The run did not come to its end."));
  add_facts(section, {{"version", run.version},
                      {"cases", std::to_string(run.cases.size())},
                      {"meshes decided", std::to_string(run.meshes.size())},
                      {"meshes asked for", std::to_string(run.asked())},
                      {"which meshes", run.final_only ? "the last one of each case" : "each one of each case"},
                      {"budget of pairs", run.budget == 0 ? "none" : std::to_string(run.budget)},
                      {"verdicts that hold", std::to_string(count_of(run, Outcome::holds))},
                      {"violated", std::to_string(violated)},
                      {"not applicable", std::to_string(count_of(run, Outcome::not_applicable))},
                      {"undecided", std::to_string(undecided)}});
}

/// The command that makes this run again, in its directory.
std::string command_of(const CheckRun& run) {
  std::string command = "asts check";
  for (const Property* property : run.properties) command += std::string(" --property ") + property->id;
  for (const Claim* claim : run.claims) command += std::string(" --claim ") + claim->id;
  if (run.final_only) command += " --final";
  if (run.budget > 0) command += fmt::format(" --budget {}", run.budget);
  for (const CheckRun::CheckedCase& one : run.cases) command += " " + one.file;
  return command;
}

void add_about(HtmlNode main, const CheckRun& run, const std::string& version) {
  HtmlNode section = add_section(main, 2, "about", "Versions");
  add_facts(section, {{"version that decided", run.version},
                      {"seed", "none: nothing is random"},
                      {"version that wrote this page", version}});
  add_paragraph(section,
                "In the run directory, to decide all of it again, and to have the witnesses decided by the "
                "literal code:");
  add_command(section, command_of(run));
  add_command(section, "asts validate records.jsonl");
}

}  // namespace

std::vector<std::int64_t> checked_steps(const Case& content, bool final_only) {
  if (content.explicit_mesh) return {0};
  const auto last = static_cast<std::int64_t>(content.steps.size());
  std::vector<std::int64_t> steps;
  for (std::int64_t step = final_only ? last : 0; step <= last; ++step) steps.push_back(step);
  return steps;
}

std::size_t CheckRun::asked() const {
  std::size_t count = 0;
  for (const CheckedCase& one : cases) count += checked_steps(one.content, final_only).size();
  return count;
}

std::string check_page(const CheckRun& run, const std::string& version) {
  PageFrame frame("Report of a check", lead(run),
                  {{"summary", "Summary"},
                   {"claims", "Statements"},
                   {"findings", "Findings"},
                   {"meshes", "Meshes"},
                   {"generated", "What was checked"},
                   {"performance", "Performance"},
                   {"about", "Versions"}});
  add_summary(frame.main(), run);
  add_statements(frame.main(), run);
  MeshGallery gallery;
  add_check_findings(frame.main(), run, gallery);
  add_meshes(frame.main(), run, gallery);
  add_sizes(frame.main(), run);
  add_paragraph(add_section(frame.main(), 2, "performance", "Performance"), "A check records no times.");
  add_about(frame.main(), run, version);
  return std::move(frame).text();
}

}  // namespace asts
