#include "reports/claims_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/checked_in_ledger.hpp"
#include "reports/ledger_report.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

Json exhaustive_json(const ExhaustiveRecord& record) {
  return {{"degree", record.setting.degree},
          {"grading", record.setting.grading},
          {"domain", record.setting.domain},
          {"max_subdivisions", record.max_subdivisions},
          {"admissible", record.admissible},
          {"meshes", record.meshes},
          {"applicable", record.applicable},
          {"violations", record.violations},
          {"met", record.met}};
}

/// How far the claim has been tried, by the checked-in results; null when it has not been.
Json tried_json(std::string_view claim) {
  const auto found = checked_in_ledger().find(claim);
  if (found == checked_in_ledger().end()) return nullptr;
  const LedgerRecord& record = found->second.record;
  Json json{{"trials", record.trials()},           {"meshes", record.meshes},
            {"sequences", record.sequences},       {"met", record.met},
            {"trials_met", record.trials_met},     {"violated", record.violated},
            {"bounds", bounds_json(record.bounds)}};
  json["exhaustive"] = Json::array();
  for (const ExhaustiveRecord& one : found->second.exhaustive) json["exhaustive"].push_back(exhaustive_json(one));
  return json;
}

std::string finding_of(const Claim& claim) { return fmt::format("reports/findings/{}.md", claim.id); }

}  // namespace

const char* status_name(const Claim& claim) { return claim.refuted ? "refuted" : "unrefuted"; }

std::string claim_json(const Claim& claim) {
  Json json{{"id", claim.id},
            {"source", claim.source},
            {"statement", claim.statement},
            {"kind", kind_name(claim.kind)},
            {"meshes", claim.meshes},
            {"status", status_name(claim)}};
  if (claim.refuted) json["finding"] = finding_of(claim);
  json["tried"] = tried_json(claim.id);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string claim_text(const Claim& claim) {
  const std::string finding = claim.refuted ? fmt::format("  ({})", finding_of(claim)) : "";
  const std::string tried = tried_text(claim.id);
  return fmt::format("{}: {}{}\n    {}, {}: {}\n    tried: {}\n", claim.id, status_name(claim), finding,
                     kind_name(claim.kind), claim.source, claim.statement, tried.empty() ? "not yet" : tried);
}

}  // namespace asts
