#include "reports/claims_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace asts {

namespace {

std::string finding_of(const Claim& claim) { return fmt::format("reports/findings/{}.md", claim.id); }

}  // namespace

const char* status_name(const Claim& claim) { return claim.refuted ? "refuted" : "unrefuted"; }

std::string claim_json(const Claim& claim) {
  nlohmann::ordered_json json{{"id", claim.id},
                              {"source", claim.source},
                              {"statement", claim.statement},
                              {"kind", kind_name(claim.kind)},
                              {"meshes", claim.meshes},
                              {"status", status_name(claim)}};
  if (claim.refuted) json["finding"] = finding_of(claim);
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string claim_text(const Claim& claim) {
  const std::string finding = claim.refuted ? fmt::format("  ({})", finding_of(claim)) : "";
  return fmt::format("{}: {}{}\n    {}, {}: {}\n", claim.id, status_name(claim), finding, kind_name(claim.kind),
                     claim.source, claim.statement);
}

}  // namespace asts
