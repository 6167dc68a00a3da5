#include "fuzz/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/collected_cases.hpp"
#include "cli/commands.hpp"
#include "cli/statements.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "reports/campaign_json.hpp"
#include "reports/campaign_junit.hpp"
#include "reports/campaign_sarif.hpp"
#include "reports/campaign_text.hpp"

namespace asts::cli {

namespace {

/// When neither a number nor a time is asked for.
constexpr std::int64_t kUsualCases = 2000;

std::vector<StoredCase> stored_cases(const std::string& folder, const std::vector<const Claim*>& claims) {
  std::vector<StoredCase> stored;
  if (folder.empty()) return stored;
  for (CollectedCase& collected : read_collection(folder)) {
    const Claim* claim = collected.about.statement.claim;
    if (std::find(claims.begin(), claims.end(), claim) == claims.end()) continue;
    stored.push_back({collected.name, claim, collected.about.kind, std::move(collected.content)});
  }
  return stored;
}

CampaignPlan plan_of(const CampaignOptions& options) {
  CampaignPlan plan;
  plan.version = ASTS_VERSION;
  plan.claims = chosen_claims(options.claims);
  if (plan.claims.empty()) {
    for (const Claim& claim : all_claims()) plan.claims.push_back(&claim);
  }
  plan.named = !options.claims.empty();
  plan.seed = options.seed.value_or(plan.seed);
  plan.stored = stored_cases(options.replayed, plan.claims);
  return plan;
}

/// What was begun, when that is what is asked for: what is not said again stays as it was.
CampaignPlan resumed_plan(const CampaignOptions& options, const CampaignPlan& begun) {
  CampaignOptions asked = options;
  if (asked.claims.empty()) {
    for (const Claim* claim : begun.claims) asked.claims.emplace_back(claim->id);
  }
  if (!asked.seed) asked.seed = begun.seed;
  CampaignPlan plan = plan_of(asked);
  plan.named = begun.named;
  if (asked.replayed.empty()) plan.stored = begun.stored;
  if (plan == begun) return plan;
  throw InputError(options.folder + ": was begun by another version, or with other claims, seed or stored cases");
}

std::int64_t cases_of(const CampaignOptions& options, const RunDirectory* folder) {
  if (options.seconds) return 0;
  const bool begun = folder != nullptr && folder->begun();
  const std::int64_t usual = begun ? folder->begun()->cases : kUsualCases;
  if (!options.cases && usual == 0) throw InputError("--resume of a campaign for a time needs --cases or --time");
  return options.cases.value_or(usual);
}

CampaignRun run_of(const CampaignOptions& options, const RunDirectory* folder) {
  CampaignRun run;
  run.cases = cases_of(options, folder);
  if (options.seconds) run.time = std::chrono::seconds(*options.seconds);
  run.jobs = options.jobs;
  run.limits = {options.timeout, options.memory};
  run.stop = interrupted;
  run.progress = show_progress;
  return run;
}

int exit_code(const CampaignResult& result, bool healthy) {
  if (result.interrupted) return kInterrupted;
  const auto& findings = result.summary.findings;
  const bool violated =
      std::any_of(findings.begin(), findings.end(), [](const CampaignFinding& finding) { return !finding.expected; });
  return violated ? kViolated : healthy ? kHolds : kFailure;
}

}  // namespace

int campaign(const CampaignOptions& options) {
  std::optional<RunDirectory> folder;
  if (options.resume && options.folder.empty()) throw InputError("--resume needs --out");
  if (!options.folder.empty()) folder.emplace(options.folder, options.resume);
  RunDirectory* recorded = folder ? &*folder : nullptr;
  const CampaignPlan plan = folder && folder->begun() ? resumed_plan(options, folder->begun()->plan) : plan_of(options);
  const CampaignResult result = run_campaign(plan, run_of(options, recorded), recorded);
  show_progress({});
  const std::vector<HealthProblem> problems = check_health(result.summary);
  const std::string json = campaign_json(result.summary, problems);
  const std::string text = campaign_text(result.summary, problems);
  if (folder) {
    folder->write_file("statistics.json", json);
    folder->write_file("statistics.txt", text);
    folder->write_file("junit.xml", campaign_junit(result.summary, problems));
    folder->write_file("results.sarif", campaign_sarif(result.summary, problems));
  }
  print(options.format == Format::json ? json : text);
  const auto slow = check_speed(result.times);
  if (slow) warn("asts: " + slow->check + ": " + slow->says + "\n");
  return exit_code(result, problems.empty() && !slow);
}

}  // namespace asts::cli
