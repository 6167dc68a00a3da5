#include "fuzz/campaign/recorded_run.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "fuzz/campaign/recorded_finding.hpp"
#include "fuzz/campaign/run_directory.hpp"
#include "fuzz/campaign/sealed_lines.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "properties/campaign/health.hpp"
#include "reports/campaign_json.hpp"
#include "reports/witness_reading.hpp"

namespace asts {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Unit = CampaignRecords::Unit;

/// "case 7, step 2"
std::string place_text(const std::optional<std::int64_t>& number, std::int64_t step) {
  if (!number) return "without a case";
  return fmt::format("{} {}, step {}", *number < 0 ? "stored case" : "case", *number < 0 ? -*number : *number, step);
}

std::string what_text(const CampaignPlan& plan, const UnitRecord& record) {
  const asts::Unit unit = unit_of(plan, record.unit);
  if (unit.kind == asts::Unit::Kind::alone) return std::string(plan.claims[unit.place]->id) + ", without a case";
  if (unit.kind == asts::Unit::Kind::stored) return "stored cases";
  return fmt::format("cases {} to {}", unit.first_case, record.end - 1);
}

Unit unit_from(const CampaignPlan& plan, const UnitRecord& record) {
  Unit unit{record.unit,
            what_text(plan, record),
            record.cases,
            record.meshes,
            static_cast<std::int64_t>(record.fresh.size()),
            record.trivial,
            record.sequences,
            {}};
  for (const UnitViolation& one : record.violations) {
    unit.events.push_back(fmt::format("{}: {} {}, first in {}{}{}", one.claim, one.count, one.kind,
                                      place_text(one.number, one.step), one.says.empty() ? "" : ": ", one.says));
  }
  for (const UnitDeath& one : record.deaths) {
    unit.events.push_back(
        fmt::format("{}: {} in {}: {}", one.claim, one.kind, place_text(one.number, one.step), one.says));
  }
  return unit;
}

/// What campaigns write: a block has its 64 cases, or the last one fewer.
void require_shape(const CampaignPlan& plan, const UnitRecord& record, const std::string& line) {
  require(unit_json(record) == line, "no record of a unit as campaigns write it");
  const asts::Unit unit = unit_of(plan, record.unit);
  const bool block = unit.kind == asts::Unit::Kind::block;
  const std::int64_t most = block ? record.end - unit.first_case : static_cast<std::int64_t>(plan.stored.size());
  require(!block || (record.end > unit.first_case && most <= kBlockCases), "a block of cases ends where none does");
  require(record.cases >= 0 && record.cases <= most, "a unit has more cases than it was given");
}

/// Reads units.jsonl behind the plan into the state and the records.
void read_units(SealedLines& lines, const CampaignPlan& plan, CampaignState& state, CampaignRecords& records) {
  while (const auto line = lines.next()) {
    lines.at_this_line([&] {
      const UnitRecord record = unit_from_json(*line);
      require(record.unit == state.next_unit(), "a unit is missing");
      require_shape(plan, record, *line);
      state.add_unit(record);
      records.units.push_back(unit_from(plan, record));
    });
  }
}

CampaignRecords::Times times_from(const CampaignPlan& plan, const std::string& line) {
  const Json json = Json::parse(line);
  CampaignRecords::Times times{
      count_in(json, "unit"), count_in(json, "microseconds"), count_in(json, "slowest"), 0, {}};
  require(json.contains("number") && json["number"].is_number_integer(), "there is no 'number'");
  times.slowest_number = json["number"];
  require(json.contains("claims") && json["claims"].is_array(), "there are no times of claims");
  for (const Json& one : json["claims"]) {
    require(one.is_number_unsigned(), "a claim's time is no count");
    times.claims.push_back(one);
  }
  require(times.claims.size() == plan.claims.size(), "there is not a time for each claim");
  return times;
}

void read_times(const std::string& path, const CampaignPlan& plan, CampaignRecords& records) {
  if (!fs::exists(path)) return;
  SealedLines lines(path);
  while (const auto line = lines.next()) {
    lines.at_this_line([&] { records.times.push_back(times_from(plan, *line)); });
  }
}

std::string value_text(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  constexpr std::size_t kLongest = 120;
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

/// Beyond, more of them say nothing new.
constexpr std::size_t kMostDifferences = 50;

/// Where two JSON values differ, by the names of their members.
void compare(const std::string& name, const Json& recorded, const Json& file, std::vector<std::string>& differences) {
  if (recorded == file || differences.size() >= kMostDifferences) return;
  const bool members = recorded.is_structured() && recorded.type() == file.type() && recorded.size() == file.size();
  if (!members) {
    differences.push_back(
        fmt::format("statistics.json: {} is {}, and {} by the records", name, value_text(file), value_text(recorded)));
    return;
  }
  std::size_t place = 0;
  for (const auto& [key, value] : recorded.items()) {
    const Json* other = recorded.is_array() ? &file.at(place++) : file.contains(key) ? &file.at(key) : nullptr;
    const std::string member = name.empty() ? key : name + "." + key;
    compare(member, value, other == nullptr ? Json() : *other, differences);
  }
}

void compare_statistics(const std::string& path, CampaignRecords& records) {
  if (!fs::exists(path)) {
    records.differences.emplace_back("statistics.json is missing: the campaign did not come to its end");
    return;
  }
  const Json recorded = Json::parse(campaign_json(records.summary, records.health));
  compare("", recorded, json_of_file(path), records.differences);
}

void compare_files(const std::string& folder, CampaignRecords& records) {
  for (const CampaignFinding& finding : records.summary.findings) {
    if (!finding.content) continue;
    const std::string path = folder + "/" + finding.file;
    if (!fs::exists(path)) {
      records.differences.push_back(finding.file + " is missing");
    } else if (!(read_case_file(path) == *finding.content)) {
      records.differences.push_back(finding.file + " is not the case of its record");
    }
  }
}

}  // namespace

bool has_campaign(const std::string& folder) { return fs::exists(folder + "/units.jsonl"); }

CampaignRecords read_recorded_run(const std::string& folder) {
  const std::string units_path = folder + "/units.jsonl";
  SealedLines units(units_path);
  const auto first = units.next();
  if (!first) throw InputError(units_path + ":1: no plan of a campaign");
  RunDirectory::Begun begun;
  units.at_this_line([&] { begun = begun_from_json(*first); });
  CampaignState state(begun.plan);
  CampaignRecords records;
  records.named = begun.plan.named;
  records.cases_asked = begun.cases;
  records.minimize_budget = begun.plan.minimize_budget;
  for (const StoredCase& stored : begun.plan.stored) records.stored.push_back(stored.name);
  read_units(units, begun.plan, state, records);
  FindingDetails details;
  if (fs::exists(folder + "/findings.jsonl")) {
    SealedLines findings(folder + "/findings.jsonl");
    while (const auto line = findings.next()) {
      findings.at_this_line([&] { details.add(*line, state); });
    }
  }
  records.findings_open = static_cast<std::int64_t>(state.tasks().size() - state.next_finding());
  records.summary = state.summary();
  records.details = details.of(records.summary.findings);
  records.differences = details.differences();
  records.health = check_health(records.summary);
  read_times(folder + "/times.jsonl", begun.plan, records);
  compare_statistics(folder + "/statistics.json", records);
  compare_files(folder, records);
  return records;
}

}  // namespace asts
