#include "fuzz/campaign/run_directory.hpp"

#include <filesystem>
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
  Json json{{"campaign", kFormat},    {"version", plan.version}, {"claims", Json::array()},
            {"seed", plan.seed},      {"cases", cases},          {"minimize_budget", plan.minimize_budget},
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
  begun.plan.seed = json.at("seed");
  begun.plan.minimize_budget = json.at("minimize_budget");
  for (const Json& one : json.at("stored")) {
    begun.plan.stored.push_back({one.at("name"), claim_named(one.at("claim")), one.at("kind"),
                                 parse_case(one.at("case").get<std::string>(), one.at("name"))});
  }
  return begun;
}

std::optional<RunDirectory::Begun> plan_of(const JournalContent& units, const std::string& path) {
  if (units.objects.empty()) return std::nullopt;
  try {
    return plan_from(Json::parse(units.objects.front()));
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

/// How many lines count, the plan's among them.
std::size_t restore_units(const JournalContent& lines, const CampaignPlan& plan, std::int64_t cases,
                          CampaignState& state, const std::string& path) {
  std::size_t line = 1;
  try {
    for (; line < lines.objects.size(); ++line) {
      const UnitRecord record = unit_from_json(lines.objects[line]);
      if (is_short(plan, record, cases)) break;
      state.add_unit(record);
    }
  } catch (const InputError& error) {
    throw InputError(path + ":" + std::to_string(line + 1) + ": " + error.what());
  }
  return line;
}

std::size_t restore_findings(const JournalContent& lines, CampaignState& state, const std::string& path) {
  std::size_t line = 0;
  try {
    for (; line < lines.objects.size() && line < state.tasks().size(); ++line) {
      state.add_finding(finding_from_json(lines.objects[line]));
    }
  } catch (const InputError& error) {
    throw InputError(path + ":" + std::to_string(line + 1) + ": " + error.what());
  }
  return line;
}

std::uint64_t bytes_of(const JournalContent& content, std::size_t lines) {
  return lines == 0 ? 0 : content.ends[lines - 1];
}

}  // namespace

RunDirectory::RunDirectory(std::string folder, bool resume) : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_ + "/findings", error);
  if (error) throw InputError(folder_ + ": cannot be made: " + error.message());
  lock_ = std::make_unique<FolderLock>(folder_);
  unit_lines_ = read_journal(path(kUnits));
  finding_lines_ = read_journal(path(kFindings));
  begun_ = plan_of(unit_lines_, path(kUnits));
  if (begun_ && !resume) throw InputError(folder_ + ": has a campaign already; --resume goes on with it");
}

void RunDirectory::open_journals(std::size_t units, std::size_t findings) {
  units_ = std::make_unique<Journal>(path(kUnits), bytes_of(unit_lines_, units));
  findings_ = std::make_unique<Journal>(path(kFindings), bytes_of(finding_lines_, findings));
  const JournalContent times = read_journal(path(kTimes));
  times_ = std::make_unique<Journal>(path(kTimes), bytes_of(times, begun_ ? times.ends.size() : 0));
}

void RunDirectory::begin(const CampaignPlan& plan, std::int64_t cases) {
  open_journals(0, 0);
  units_->append(plan_json(plan, cases));
}

void RunDirectory::restore(CampaignState& state, std::int64_t cases) {
  const std::size_t units = restore_units(unit_lines_, begun_->plan, cases, state, path(kUnits));
  const std::size_t findings = restore_findings(finding_lines_, state, path(kFindings));
  open_journals(units, findings);
  for (const CampaignFinding& finding : state.summary().findings) write_case_of(finding);
}

void RunDirectory::write_case_of(const CampaignFinding& finding) const {
  if (finding.content) write_file(finding.file, write_case(*finding.content));
}

void RunDirectory::add_finding(const std::string& object, const CampaignFinding& finding) {
  write_case_of(finding);
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

std::optional<RecordedCampaign> read_campaign(const std::string& folder) {
  if (!fs::is_directory(folder)) throw InputError(folder + ": is no folder");
  const std::string units = folder + "/" + kUnits;
  const std::string findings = folder + "/" + kFindings;
  if (!fs::exists(units)) throw InputError(folder + ": has no campaign");
  const JournalContent unit_lines = read_journal(units);
  const auto begun = plan_of(unit_lines, units);
  if (!begun) return std::nullopt;
  CampaignState state(begun->plan);
  restore_units(unit_lines, begun->plan, 0, state, units);
  restore_findings(read_journal(findings), state, findings);
  return RecordedCampaign{begun->plan, state.summary()};
}

}  // namespace asts
