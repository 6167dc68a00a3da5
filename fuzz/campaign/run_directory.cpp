#include "fuzz/campaign/run_directory.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kUnits = "units.jsonl";
constexpr const char* kFindings = "findings.jsonl";
constexpr const char* kTimes = "times.jsonl";
constexpr int kFormat = 1;  ///< of the folder

std::string plan_json(const CampaignPlan& plan, std::int64_t cases) {
  Json json{{"campaign", kFormat},
            {"version", plan.version},
            {"claims", Json::array()},
            {"named", plan.named},
            {"seed", plan.seed},
            {"cases", cases},
            {"minimize_budget", plan.minimize_budget},
            {"stored", Json::array()}};
  for (const Claim* claim : plan.claims) json["claims"].push_back(claim->id);
  for (const StoredCase& stored : plan.stored) {
    json["stored"].push_back({{"name", stored.name},
                              {"claim", stored.claim->id},
                              {"kind", stored.kind},
                              {"case", write_case(stored.content)}});
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

const Claim* claim_named(const std::string& id) {
  const Claim* claim = find_claim(id);
  if (claim == nullptr) throw InputError("'" + id + "' is no claim");
  return claim;
}

RunDirectory::Begun plan_from(const Json& json) {
  require(json.at("campaign") == kFormat, "a campaign of another form");
  RunDirectory::Begun begun;
  begun.cases = json.at("cases");
  begun.plan.version = json.at("version");
  for (const Json& id : json.at("claims")) begun.plan.claims.push_back(claim_named(id));
  begun.plan.named = json.at("named");
  begun.plan.seed = json.at("seed");
  begun.plan.minimize_budget = json.at("minimize_budget");
  for (const Json& one : json.at("stored")) {
    begun.plan.stored.push_back({one.at("name"), claim_named(one.at("claim")), one.at("kind"),
                                 parse_case(one.at("case").get<std::string>(), one.at("name"))});
  }
  return begun;
}

/// The plan in the first line; nothing when that is not complete.
std::optional<RunDirectory::Begun> read_plan(JournalReader& units, const std::string& path) {
  const auto line = units.next();
  if (!line) return std::nullopt;
  try {
    return plan_from(Json::parse(*line));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(path + ":1: no plan of a campaign: " + error.what());
  } catch (const InputError& error) {
    throw InputError(path + ":1: " + error.what());
  }
}

/// Whether a record is of a block that has fewer cases than it now is to have.
bool is_short(const CampaignPlan& plan, const UnitRecord& record, std::int64_t cases) {
  const Unit unit = unit_of(plan, record.unit);
  return unit.kind == Unit::Kind::block && record.end < std::min(unit.first_case + kBlockCases, cases);
}

/// Calls `take` for the record in the line that was read last, and names the line when it is none.
template <typename Take>
bool take_line(const JournalReader& lines, const std::string& path, const Take& take) {
  try {
    return take();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}:{}: {}", path, lines.line(), error.what()));
  }
}

/// The records behind the plan. Gives the end of those that count, in bytes.
std::uint64_t restore_units(JournalReader& lines, const CampaignPlan& plan, std::int64_t cases, CampaignState& state,
                            const std::string& path) {
  std::uint64_t end = lines.end();
  for (auto line = lines.next(); line; line = lines.next()) {
    const bool counts = take_line(lines, path, [&] {
      const UnitRecord record = unit_from_json(*line);
      if (is_short(plan, record, cases)) return false;
      state.add_unit(record);
      return true;
    });
    if (!counts) break;
    end = lines.end();
  }
  return end;
}

/// Findings whose tasks the units gave. Gives the end of those that count, in bytes.
std::uint64_t restore_findings(CampaignState& state, const std::string& path) {
  JournalReader lines(path);
  std::uint64_t end = 0;
  while (state.next_finding() < state.tasks().size()) {
    const auto line = lines.next();
    if (!line) break;
    take_line(lines, path, [&] {
      state.add_finding(finding_from_json(*line));
      return true;
    });
    end = lines.end();
  }
  return end;
}

/// The end of what is complete, in bytes; where something is damaged, nothing is.
std::uint64_t end_of_times(const std::string& path) {
  try {
    JournalReader lines(path);
    while (lines.next()) {
    }
    return lines.end();
  } catch (const InputError&) {
    return 0;  // nothing depends on it
  }
}

/// A first line that is cut, or nothing: what may be begun anew.
bool is_beginning(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  return !file || !std::getline(file, line) || file.eof();
}

}  // namespace

RunDirectory::RunDirectory(std::string folder, bool resume) : folder_(std::move(folder)) {
  std::error_code error;
  for (const char* name : {kFindingFolder, kDeathFolder}) {
    if (!error) fs::create_directories(folder_ + "/" + name, error);
  }
  if (error) throw InputError(folder_ + ": cannot be made: " + error.message());
  lock_ = std::make_unique<FolderLock>(folder_);
  JournalReader units(path(kUnits));
  begun_ = read_plan(units, path(kUnits));
  if (!begun_ && !is_beginning(path(kUnits))) throw InputError(path(kUnits) + ":1: no plan of a campaign");
  if (begun_ && !resume) throw InputError(folder_ + ": has a campaign already; --resume goes on with it");
}

void RunDirectory::open_journals(std::uint64_t units_end, std::uint64_t findings_end) {
  units_ = std::make_unique<Journal>(path(kUnits), units_end);
  findings_ = std::make_unique<Journal>(path(kFindings), findings_end);
  times_ = std::make_unique<Journal>(path(kTimes), begun_ ? end_of_times(path(kTimes)) : 0);
}

void RunDirectory::begin(const CampaignPlan& plan, std::int64_t cases) {
  open_journals(0, 0);
  units_->append(plan_json(plan, cases));
}

void RunDirectory::restore(CampaignState& state, std::int64_t cases) {
  JournalReader units(path(kUnits));
  units.next();  // the plan
  const std::uint64_t units_end = restore_units(units, begun_->plan, cases, state, path(kUnits));
  open_journals(units_end, restore_findings(state, path(kFindings)));
  for (const CampaignFinding& finding : state.summary().findings) write_case_of(finding);
}

void RunDirectory::write_case_of(const CampaignFinding& finding) const {
  if (finding.content) write_file(finding.file, write_case(*finding.content));
}

void RunDirectory::add_finding(const std::string& object, const std::vector<CampaignFinding>& findings) {
  for (const CampaignFinding& finding : findings) write_case_of(finding);
  findings_->append(object);
}

void RunDirectory::add_times(std::int64_t unit, const UnitTimes& times) {
  const Json json{{"unit", unit},
                  {"microseconds", times.total},
                  {"slowest", times.slowest},
                  {"number", times.slowest_number},
                  {"claims", times.claims}};
  times_->append(json.dump());
}

void RunDirectory::write_file(const std::string& name, const std::string& content) const {
  replace_file(folder_ + "/" + name, content);
}

RunDirectory::Begun begun_from_json(const std::string& line) {
  RunDirectory::Begun begun = plan_from(Json::parse(line));
  require(plan_json(begun.plan, begun.cases) == line, "no plan as campaigns write it");
  return begun;
}

std::optional<RecordedCampaign> read_campaign(const std::string& folder) {
  if (!fs::is_directory(folder)) throw InputError(folder + ": is no folder");
  const std::string units = folder + "/" + kUnits;
  const std::string findings = folder + "/" + kFindings;
  if (!fs::exists(units)) throw InputError(folder + ": has no campaign");
  JournalReader lines(units);
  const auto begun = read_plan(lines, units);
  if (!begun) return std::nullopt;
  CampaignState state(begun->plan);
  restore_units(lines, begun->plan, 0, state, units);
  restore_findings(state, findings);
  return RecordedCampaign{begun->plan, state.summary()};
}

}  // namespace asts
