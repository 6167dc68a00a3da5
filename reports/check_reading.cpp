#include "reports/check_reading.hpp"

#include "lib/exact/errors.hpp"
#include "reports/witness_reading.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

CheckRecord::Figures figures_from(const Json& json) {
  CheckRecord::Figures figures;
  figures.elements = count_in(json, "elements");
  figures.new_elements = count_in(json, "new_elements");
  if (!json.at("max_level").is_null()) figures.max_level = static_cast<std::int32_t>(count_in(json, "max_level"));
  figures.active_nodes = count_in(json, "active_nodes");
  return figures;
}

void read_properties(const Json& json, CheckRecord& record) {
  for (const auto& [id, verdict] : json.items()) {
    const Property* property = find_property(id);
    if (property == nullptr) throw InputError("no property is called '" + id + "'");
    record.entries.push_back({property, verdict_from_json(verdict)});
  }
}

void read_claims(const Json& json, CheckRecord& record) {
  for (const auto& [id, verdict] : json.items()) {
    const Claim* claim = find_claim(id);
    if (claim == nullptr) throw InputError("no claim is called '" + id + "'");
    record.claims.push_back({claim, {verdict_from_json(verdict), count_in(verdict, "met")}});
  }
}

CheckRecord record_from(const Json& json) {
  CheckRecord record;
  record.case_name = text_in(json, "case");
  record.step = count_in(json, "step");
  if (json.contains("elements")) record.mesh = figures_from(json);
  if (json.contains("properties")) read_properties(json["properties"], record);
  if (json.contains("claims")) read_claims(json["claims"], record);
  if (json.contains("mesh")) record.mesh_case = text_in(json, "mesh");
  return record;
}

}  // namespace

CheckRecord check_record_from_json(std::string_view line) {
  try {
    CheckRecord record = record_from(Json::parse(line));
    require(check_json(record) == std::string(line) + "\n", "the record has other members than asts check writes");
    return record;
  } catch (const Json::parse_error&) {
    throw InputError("the record is cut off or no JSON");
  } catch (const Json::exception& error) {
    const std::string reason = error.what();  // "[json.exception.NAME.NUMBER] words"
    throw InputError("no record of asts check: " + reason.substr(reason.find("] ") + 2));
  }
}

}  // namespace asts
