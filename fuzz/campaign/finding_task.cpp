#include "fuzz/campaign/finding_task.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "fuzz/campaign/death_oracle.hpp"
#include "fuzz/campaign/optional_number.hpp"
#include "fuzz/validation/validate_record.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/case_prefix.hpp"
#include "reports/collection.hpp"
#include "reports/ledger_report.hpp"
#include "reports/minimize_report.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

/// What the case is called whose minimization a record tells.
constexpr const char* kDrawn = "drawn";

/// nullptr when no claim was being tried.
const Claim* claim_of(const CampaignPlan& plan, const FindingTask& task) {
  const auto found =
      std::find_if(plan.claims.begin(), plan.claims.end(), [&](const Claim* claim) { return claim->id == task.claim; });
  return found != plan.claims.end() ? *found : nullptr;
}

/// The case as it was drawn, up to the mesh of the task; nothing when it could not even be made.
std::optional<Case> drawn_case(const CampaignPlan& plan, const FindingTask& task) {
  if (!task.number || task.step < 0) return std::nullopt;
  return case_prefix(campaign_case(plan, *task.number).content, static_cast<std::size_t>(task.step));
}

/// A violation of a claim that is refuted already, if nobody named it. Nothing else is expected.
bool is_expected(const CampaignPlan& plan, const FindingTask& task) {
  if (task.died || task.number.value_or(0) < 0) return false;
  const Claim* claim = claim_of(plan, task);
  return claim != nullptr && claim->refuted && !plan.named;
}

void add_case(Json& found, const std::string& claim, const std::string& kind, bool died, const Case& content) {
  const std::string name = collection_name(claim.empty() ? "none" : claim, kind, content);
  found["file"] = std::string(died ? kDeathFolder : kFindingFolder) + "/" + name;
  found["mesh"] = write_case(content);
}

Json found_json(const CampaignPlan& plan, const FindingTask& task, const std::string& says) {
  return {{"claim", task.claim},
          {"kind", task.kind},
          {"expected", is_expected(plan, task)},
          {"number", number_json(task.number)},
          {"step", task.step},
          {"says", says}};
}

/// What did not come back while a smaller case was looked for.
Json spoiled_json(const FindingTask& task) {
  Json found{{"claim", task.claim},
             {"kind", task.spoiled->kind},
             {"expected", false},
             {"number", nullptr},
             {"step", 0},
             {"says", task.spoiled->says + ", while a case was made smaller that is violated: " + task.kind}};
  if (!task.spoiled_by.empty()) {
    add_case(found, task.claim, task.spoiled->kind, true, parse_case(task.spoiled_by, "tried"));
  }
  return found;
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Minimized minimize_it(const CampaignPlan& plan, const Statement& statement, const Case& drawn,
                      const Predicate& predicate) {
  Oracle::Options options;
  options.budget = plan.minimize_budget;
  return minimize(drawn, statement.of_sequence() ? PathForm::sequence : PathForm::mesh, predicate, options);
}

/// Decided by the literal code: once, from what was written.
void add_validation(Json& json) {
  const auto record = parse_record(dumped(json));
  ensure(record.has_value(), "a finding is a record");
  for (const ValidatedWitness& witness : validate_record(*record, "", "finding")) {
    json["found"]["valid"] = witness.validation.valid;
    json["found"]["validation"] = witness.validation.report;
  }
}

/// The members of a finding that say how small it is.
constexpr std::array kSizeMembers{"size", "guarantee", "evaluations", "last_run", "others"};

Json violation_json(const CampaignPlan& plan, const FindingTask& task, const Claim& claim, const Case& drawn,
                    const TaskWatch& watch) {
  MinimizedReport report{kDrawn, {&claim, nullptr}, {}, {}, {}};
  const Predicate violates = [&](const Case& one) {
    watch(one);
    return violation_of(report.statement, one);
  };
  if (task.spoiled) {
    report.minimized.smallest = drawn;
    report.minimized.kind = task.kind;
  } else {
    report.minimized = minimize_it(plan, report.statement, drawn, violates);
  }
  const Case& smallest = report.minimized.smallest;
  watch(smallest);
  report.trial = try_on_case(report.statement, smallest);
  Json json = Json::parse(minimized_json(report));
  if (task.spoiled) {
    json.erase("elements");  // of a size that was not asked for
    for (const char* member : kSizeMembers) json.erase(member);
  }
  json["found"] = found_json(plan, task, violation_text(report.trial.verdict));
  add_case(json["found"], task.claim, task.kind, false, smallest);
  watch(smallest);
  add_validation(json);
  return json;
}

/// Without a witness: the claims that `asts validate` looks for are none.
Json unwitnessed(const CampaignPlan& plan, const FindingTask& task, const std::string& says,
                 const std::optional<Case>& content) {
  Json json{{"claims", Json::object()}, {"found", found_json(plan, task, says)}};
  if (content) add_case(json["found"], task.claim, task.kind, task.died, *content);
  return json;
}

Json death_json(const CampaignPlan& plan, const FindingTask& task, const Claim& claim, const Case& drawn,
                std::int64_t timeout_seconds, const TaskWatch& watch) {
  const Statement statement{&claim, nullptr};
  watch(drawn);
  const Ending first = ending_alone(statement, drawn, timeout_seconds);
  if (first.kind != task.kind) {
    return unwitnessed(plan, task, task.says + "; not when the claim was tried again on this case alone", drawn);
  }
  const Predicate dies = [&](const Case& one) -> ViolationKind {
    watch(one);
    const Ending ending = ending_alone(statement, one, timeout_seconds);
    return ending == first ? ViolationKind(task.kind) : std::nullopt;
  };
  const MinimizedReport report{kDrawn, statement, minimize_it(plan, statement, drawn, dies), {}, {}};
  const Json sizes = Json::parse(minimized_json(report));
  Json json = unwitnessed(plan, task, task.says, report.minimized.smallest);
  for (const char* member : kSizeMembers) json[member] = sizes.at(member);
  return json;
}

Json worked_out(const CampaignPlan& plan, const FindingTask& task, std::int64_t timeout_seconds,
                const TaskWatch& watch) {
  const std::optional<Case> drawn = drawn_case(plan, task);
  const Claim* claim = claim_of(plan, task);
  const bool stored = task.number.value_or(0) < 0;
  if (!drawn || claim == nullptr || stored) return unwitnessed(plan, task, task.says, drawn);
  if (!task.died) return violation_json(plan, task, *claim, *drawn, watch);
  if (task.spoiled || !can_be_tried_again(task.kind)) return unwitnessed(plan, task, task.says, drawn);
  return death_json(plan, task, *claim, *drawn, timeout_seconds, watch);
}

std::string finished(Json json, const FindingTask& task) {
  json["task"] = task.index;
  if (task.spoiled) json["spoiled"] = spoiled_json(task);
  return dumped(json);
}

FindingSize size_from(const Json& json, const Case& content) {
  FindingSize result;
  const Json& size = json.at("size");
  result.size.boxes = size.at("form") == "boxes";
  result.size.subdivisions = size.at(result.size.boxes ? "boxes" : "subdivisions");
  result.size.steps = size.at("steps");
  result.size.volume = size.at("volume");
  for (const int degree : content.degree) result.size.degree += degree;
  result.size.grading = size.at("grading");
  result.size.depth = size.at("depth");
  result.evaluations = json.at("evaluations");
  for (const Guarantee one : {Guarantee::one_minimal, Guarantee::budget, Guarantee::interrupted}) {
    if (json.at("guarantee") == guarantee_name(one)) result.guarantee = one;
  }
  return result;
}

CampaignFinding finding_from(const Json& found) {
  CampaignFinding finding;
  finding.claim = found.at("claim");
  finding.kind = found.at("kind");
  finding.expected = found.at("expected");
  finding.number = number_from(found.at("number"));
  finding.step = found.at("step");
  finding.says = found.at("says");
  if (found.contains("file")) {
    finding.file = found.at("file");
    finding.content = parse_case(found.at("mesh").get<std::string>(), "mesh");
  }
  if (found.contains("valid")) {
    finding.valid = found.at("valid").get<bool>();
    finding.validation = found.at("validation");
  }
  return finding;
}

FindingRecord record_from(const Json& json) {
  FindingRecord record{json.at("task"), {finding_from(json.at("found"))}};
  CampaignFinding& finding = record.findings.front();
  if (json.contains("size")) finding.minimized = size_from(json, finding.content.value());
  if (json.contains("spoiled")) record.findings.push_back(finding_from(json.at("spoiled")));
  return record;
}

}  // namespace

FindingTask task_of(std::int64_t index, const UnitViolation& one) {
  return {index, one.claim, one.kind, one.number, one.step, one.says, false, {}, {}};
}

FindingTask task_of(std::int64_t index, const UnitDeath& one) {
  return {index, one.claim, one.kind, one.number, one.step, one.says, true, {}, {}};
}

std::string work_out(const CampaignPlan& plan, const FindingTask& task, std::int64_t timeout_seconds,
                     const TaskWatch& watch) {
  return finished(worked_out(plan, task, timeout_seconds, watch), task);
}

std::string as_drawn(const CampaignPlan& plan, const FindingTask& task) {
  return finished(unwitnessed(plan, task, task.says, drawn_case(plan, task)), task);
}

FindingRecord finding_from_json(std::string_view text) {
  try {
    return record_from(Json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("no finding: ") + error.what());
  }
}

}  // namespace asts
