#include "reports/campaign_json.hpp"

#include <nlohmann/json.hpp>

#include "lib/mesh/case_file.hpp"
#include "reports/ledger_report.hpp"
#include "reports/minimize_report.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// As in the ledger, but for the smallest case, which is a finding here.
Json record_json(const LedgerRecord& record) {
  Json json = Json::parse(ledger_json(record));
  json.erase("smallest");
  json.erase("says");
  return json;
}

Json minimized(const CampaignFinding& finding) {
  if (!finding.minimized) return nullptr;
  return {{"size", size_json(*finding.content, finding.minimized->size)},
          {"guarantee", guarantee_name(finding.minimized->guarantee)},
          {"evaluations", finding.minimized->evaluations}};
}

Json finding_json(const CampaignFinding& finding) {
  return {{"claim", finding.claim},
          {"kind", finding.kind},
          {"expected", finding.expected},
          {"number", or_null(finding.number)},
          {"step", finding.step},
          {"minimized", minimized(finding)},
          {"file", finding.file},
          {"says", finding.says},
          {"valid", or_null(finding.valid)},
          {"validation", finding.validation},
          {"case", finding.content ? Json(write_case(*finding.content)) : Json(nullptr)}};
}

Json generated_json(const CampaignSummary& summary) {
  Json json = Json::object();
  for (const auto& [feature, counts] : summary.generated) {
    json[feature] = Json::object();
    for (const auto& [value, count] : counts) json[feature][std::to_string(value)] = count;
  }
  return json;
}

template <typename T, typename ToJson>
Json list(const T& values, const ToJson& to_json) {
  Json json = Json::array();
  for (const auto& value : values) json.push_back(to_json(value));
  return json;
}

Json problem_json(const HealthProblem& problem) {
  return {{"check", problem.check}, {"subject", problem.subject}, {"says", problem.says}};
}

Json biases_json(const CampaignSummary& summary) {
  Json json = Json::object();
  for (const auto& [bias, count] : summary.biases) json[bias] = count;
  return json;
}

}  // namespace

std::string campaign_json(const CampaignSummary& summary, std::span<const HealthProblem> problems) {
  const Json json{{"version", summary.version},
                  {"claims", summary.claims},
                  {"seed", summary.seed},
                  {"cases", summary.cases},
                  {"meshes", summary.meshes},
                  {"distinct", summary.distinct},
                  {"trivial", summary.trivial},
                  {"sequences", summary.sequences},
                  {"deaths", summary.deaths},
                  {"biases", biases_json(summary)},
                  {"generated", generated_json(summary)},
                  {"records", list(summary.records, record_json)},
                  {"findings", list(summary.findings, finding_json)},
                  {"healthy", problems.empty()},
                  {"health", list(problems, problem_json)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace asts
