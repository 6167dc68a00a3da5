#include "reports/ledger_report.hpp"

#include <nlohmann/json.hpp>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "reports/claims_report.hpp"
#include "reports/witness_text.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

LedgerBounds bounds_from(const Json& json) {
  return {json.at("domain"), json.at("degree"),   json.at("grading"),
          json.at("level"),  json.at("elements"), json.at("active_nodes")};
}

Json tally_json(const std::map<std::string, std::int64_t>& tally) {
  Json json = Json::object();
  for (const auto& [name, count] : tally) json[name] = count;
  return json;
}

LedgerRecord record_from(const Json& json) {
  LedgerRecord record;
  record.claim = json.at("claim");
  record.meshes = json.at("meshes");
  record.sequences = json.at("sequences");
  record.alone = json.at("alone");
  record.holds = json.at("holds");
  record.violated = json.at("violated");
  record.not_applicable = json.at("not_applicable");
  record.undecided = json.at("undecided");
  record.met = json.at("met");
  record.trials_met = json.at("trials_met");
  for (const auto& [name, count] : json.at("biases").items()) record.biases[name] = count;
  for (const auto& [name, count] : json.at("features").items()) record.features[name] = count;
  record.bounds = bounds_from(json.at("bounds"));
  if (!json.contains("says")) return record;
  record.smallest = LedgerViolation{{}, json.at("says")};
  if (json.at("smallest").is_string()) {
    record.smallest->content = parse_case(json.at("smallest").get<std::string>(), "smallest");
  }
  return record;
}

}  // namespace

std::string violation_text(const Verdict& verdict) {
  return verdict.witness ? witness_text(*verdict.witness) : verdict.reason;
}

const char* status_of(const LedgerRecord& record) {
  const Claim* claim = find_claim(record.claim);
  return claim == nullptr ? "unknown" : status_name(*claim);
}

Json bounds_json(const LedgerBounds& bounds) {
  return {{"domain", bounds.domain}, {"degree", bounds.degree},     {"grading", bounds.grading},
          {"level", bounds.level},   {"elements", bounds.elements}, {"active_nodes", bounds.active_nodes}};
}

std::string ledger_json(const LedgerRecord& record) {
  Json json{{"claim", record.claim},
            {"status", status_of(record)},
            {"result", result_name(record.result())},
            {"meshes", record.meshes},
            {"sequences", record.sequences},
            {"alone", record.alone},
            {"holds", record.holds},
            {"violated", record.violated},
            {"not_applicable", record.not_applicable},
            {"undecided", record.undecided},
            {"met", record.met},
            {"trials_met", record.trials_met},
            {"bounds", bounds_json(record.bounds)},
            {"biases", tally_json(record.biases)},
            {"features", tally_json(record.features)},
            {"smallest", nullptr}};
  if (record.smallest) {
    if (record.smallest->content) json["smallest"] = write_case(*record.smallest->content);
    json["says"] = record.smallest->says;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

LedgerRecord ledger_from_json(std::string_view line) {
  try {
    return record_from(Json::parse(line));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("no record of a ledger: ") + error.what());
  }
}

}  // namespace asts
