#include "reports/campaign_sarif.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "properties/claims/claim.hpp"
#include "reports/campaign_text.hpp"
#include "reports/clean_text.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema = "https://json.schemastore.org/sarif-2.1.0.json";
constexpr const char* kOutsideOfClaims = "outside-of-claims";

Json text(const std::string& value) { return {{"text", clean_text(value)}}; }

std::string rule_id(const std::string& claim) { return claim.empty() ? kOutsideOfClaims : claim; }

/// Of the claims that were tried, and of those that findings name besides, in this order.
std::vector<std::string> rule_ids(const CampaignSummary& summary) {
  std::vector<std::string> ids = summary.claims;
  for (const CampaignFinding& finding : summary.findings) {
    const std::string id = rule_id(finding.claim);
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  }
  return ids;
}

Json rule(const std::string& id) {
  const Claim* claim = find_claim(id);
  if (claim == nullptr)
    return {{"id", id}, {"shortDescription", text("the code under test comes back from every case")}};
  return {{"id", id},
          {"shortDescription", text(claim->statement)},
          {"properties",
           {{"kind", kind_name(claim->kind)},
            {"source", claim->source},
            {"status", claim->refuted ? "refuted" : "unrefuted"}}}};
}

/// claim-kind-hash: the name of the file without a case's ending; without a file what is known.
std::string fingerprint(const CampaignFinding& finding) {
  if (finding.file.empty()) return rule_id(finding.claim) + "-" + finding.kind;
  return std::filesystem::path(finding.file).stem().string();
}

Json result(const CampaignFinding& finding, const std::vector<std::string>& rules) {
  const std::string id = rule_id(finding.claim);
  Json json{{"ruleId", id},
            {"ruleIndex", std::find(rules.begin(), rules.end(), id) - rules.begin()},
            {"level", finding.expected ? "note" : "error"},
            {"message", text(finding_name(finding) + "\n" + finding_text(finding))},
            {"locations", Json::array()}};
  if (!finding.file.empty()) {
    json["locations"].push_back({{"physicalLocation", {{"artifactLocation", {{"uri", finding.file}}}}}});
  }
  json["partialFingerprints"] = {{"claimKindCase/v1", fingerprint(finding)}};
  return json;
}

Json notification(const HealthProblem& problem) {
  const std::string subject = problem.subject.empty() ? "" : problem.subject + ": ";
  return {{"descriptor", {{"id", problem.check}}}, {"level", "error"}, {"message", text(subject + problem.says)}};
}

}  // namespace

std::string campaign_sarif(const CampaignSummary& summary, std::span<const HealthProblem> problems) {
  const std::vector<std::string> ids = rule_ids(summary);
  Json rules = Json::array();
  for (const std::string& id : ids) rules.push_back(rule(id));
  Json results = Json::array();
  for (const CampaignFinding& finding : summary.findings) results.push_back(result(finding, ids));
  Json notifications = Json::array();
  for (const HealthProblem& problem : problems) notifications.push_back(notification(problem));
  const Json driver{{"name", "asts"}, {"version", summary.version}, {"rules", rules}};
  const Json invocation{{"executionSuccessful", problems.empty()}, {"toolExecutionNotifications", notifications}};
  const Json run{{"tool", {{"driver", driver}}}, {"invocations", Json::array({invocation})}, {"results", results}};
  const Json json{{"$schema", kSchema}, {"version", "2.1.0"}, {"runs", Json::array({run})}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace asts
