#include "fuzz/campaign/finding_task.hpp"

#include <nlohmann/json.hpp>

#include "fuzz/campaign/death_oracle.hpp"
#include "fuzz/validation/validate_record.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "reports/collection.hpp"
#include "reports/ledger_report.hpp"
#include "reports/minimize_report.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

/// What the case is called whose minimization a record tells.
constexpr const char* kDrawn = "drawn";

/// The case as it was drawn, up to the mesh of the task; nothing when it could not even be made.
std::optional<Case> drawn_case(const CampaignPlan& plan, const FindingTask& task) {
  if (!task.number || task.step < 0) return std::nullopt;
  Case drawn = campaign_case(plan, *task.number).content;
  if (!drawn.explicit_mesh) drawn.steps.resize(static_cast<std::size_t>(task.step));
  return drawn;
}

/// What all findings have; `expected` as long as nothing died.
void add_origin(Json& json, const FindingTask& task, bool expected) {
  json["task"] = task.index;
  json["found"] = {{"claim", task.claim},
                   {"kind", task.kind},
                   {"expected", expected},
                   {"number", task.number ? Json(*task.number) : Json(nullptr)},
                   {"step", task.step}};
}

void add_case(Json& found, const FindingTask& task, const Case& content) {
  const std::string who = task.claim.empty() ? "none" : task.claim;
  found["file"] = "findings/" + collection_name(who, task.kind, content);
  found["mesh"] = write_case(content);
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Minimized minimize_violation(const CampaignPlan& plan, const FindingTask& task, const Statement& statement,
                             const Case& drawn, const std::function<void()>& evaluated) {
  Oracle::Options options;
  options.budget = plan.minimize_budget;
  options.evaluated = evaluated;
  const PathForm form = statement.of_sequence() ? PathForm::sequence : PathForm::mesh;
  const Predicate violates = [&](const Case& one) { return violation_of(statement, one); };
  const Predicate dies = [&](const Case& one) { return death_of(statement, one, task.kind); };
  return minimize(drawn, form, task.died ? dies : violates, options);
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

Json minimized_violation(const CampaignPlan& plan, const FindingTask& task, const Claim& claim, const Case& drawn,
                         const std::function<void()>& evaluated) {
  MinimizedReport report{kDrawn, {&claim, nullptr}, {}, {}, {}};
  report.minimized = minimize_violation(plan, task, report.statement, drawn, evaluated);
  report.trial = try_on_case(report.statement, report.minimized.smallest);
  Json json = Json::parse(minimized_json(report));
  add_origin(json, task, claim.refuted);
  json["found"]["says"] = violation_text(report.trial.verdict);
  add_case(json["found"], task, report.minimized.smallest);
  add_validation(json);
  return json;
}

/// Without a witness: the claims that `asts validate` looks for are none.
Json unwitnessed(const FindingTask& task, const std::string& says, const std::optional<Case>& content) {
  Json json{{"claims", Json::object()}};
  add_origin(json, task, false);
  json["found"]["says"] = says;
  if (content) add_case(json["found"], task, *content);
  return json;
}

Json minimized_death(const CampaignPlan& plan, const FindingTask& task, const Claim& claim, const Case& drawn,
                     const std::function<void()>& evaluated) {
  const Statement statement{&claim, nullptr};
  if (death_of(statement, drawn, task.kind) != task.kind) {
    return unwitnessed(task, task.says + "; not when the case was tried again, by itself", drawn);
  }
  const Minimized minimized = minimize_violation(plan, task, statement, drawn, evaluated);
  Json json = unwitnessed(task, task.says, minimized.smallest);
  const MinimizedReport report{kDrawn, statement, minimized, {}, {}};
  json["size"] = Json::parse(minimized_json(report)).at("size");
  json["guarantee"] = guarantee_name(minimized.guarantee);
  json["evaluations"] = minimized.evaluations;
  return json;
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

FindingRecord record_from(const Json& json) {
  FindingRecord record;
  CampaignFinding& finding = record.finding;
  const Json& found = json.at("found");
  record.task = json.at("task");
  finding.claim = found.at("claim");
  finding.kind = found.at("kind");
  finding.expected = found.at("expected");
  if (!found.at("number").is_null()) finding.number = found.at("number").get<std::int64_t>();
  finding.step = found.at("step");
  finding.says = found.at("says");
  if (found.contains("file")) {
    finding.file = found.at("file");
    finding.content = parse_case(found.at("mesh").get<std::string>(), "mesh");
  }
  if (json.contains("size")) finding.minimized = size_from(json, *finding.content);
  if (found.contains("valid")) {
    finding.valid = found.at("valid").get<bool>();
    finding.validation = found.at("validation");
  }
  return record;
}

}  // namespace

FindingTask task_of(std::int64_t index, const UnitViolation& one) {
  return {index, one.claim, one.kind, one.number, one.step, one.says, false};
}

FindingTask task_of(std::int64_t index, const UnitDeath& one) {
  return {index, one.claim, one.kind, one.number, one.step, one.says, true};
}

std::string work_out(const CampaignPlan& plan, const FindingTask& task, const std::function<void()>& evaluated) {
  const std::optional<Case> drawn = drawn_case(plan, task);
  const auto claim =
      std::find_if(plan.claims.begin(), plan.claims.end(), [&](const Claim* one) { return one->id == task.claim; });
  const bool minimizes = drawn && claim != plan.claims.end() && (!task.died || can_be_tried_again(task.kind));
  if (!minimizes || task.kind == kNotViolated) {
    Json json = unwitnessed(task, task.says, drawn);
    if (!drawn && claim != plan.claims.end() && !task.died) json["found"]["expected"] = (*claim)->refuted;
    return dumped(json);
  }
  return dumped(task.died ? minimized_death(plan, task, **claim, *drawn, evaluated)
                          : minimized_violation(plan, task, **claim, *drawn, evaluated));
}

std::string unminimized(const CampaignPlan& plan, const FindingTask& task, const std::string& why) {
  return dumped(unwitnessed(task, why, drawn_case(plan, task)));
}

FindingRecord finding_from_json(std::string_view text) {
  try {
    return record_from(Json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("no finding: ") + error.what());
  }
}

}  // namespace asts
