#include "fuzz/campaign/recorded_finding.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "fuzz/campaign/finding_task.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "reports/campaign_text.hpp"
#include "reports/collection.hpp"
#include "reports/minimize_report.hpp"
#include "reports/witness_json.hpp"
#include "reports/witness_reading.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;
using Details = CampaignRecords::Details;

std::string key_of(const CampaignFinding& finding) {
  const std::string what = finding.content ? write_case(*finding.content) : finding.says;
  return finding.claim + '\n' + finding.kind + '\n' + what;
}

/// Kinds become parts of names and commands.
bool is_word(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-';
  });
}

void require_integer(const Json& object, const char* member) {
  require(object.contains(member) && object[member].is_number_integer(), "a number is none");
}

/// The file's name follows from the rest.
void require_name(const CampaignFinding& finding) {
  require(is_word(finding.kind), "a finding's kind is no word");
  if (!finding.content) return;
  const std::string folder = is_death(finding) ? kDeathFolder : kFindingFolder;
  const std::string claim = finding.claim.empty() ? "none" : finding.claim;
  require(finding.file == folder + "/" + collection_name(claim, finding.kind, *finding.content),
          "the file of a finding is called otherwise");
}

/// What a record says twice, it must say alike.
void require_agreement(const Json& json, const CampaignFinding& finding) {
  const Json& found = json.at("found");
  require(found.at("number").is_null() || found["number"].is_number_integer(), "a case's number is none");
  require_integer(found, "step");
  require_name(finding);
  if (json.contains("claim")) require(json["claim"] == finding.claim, "a finding is of two claims");
  if (json.contains("kind")) require(json["kind"] == finding.kind, "a finding is of two kinds");
  if (json.contains("mesh")) require(json["mesh"] == found.at("mesh"), "a finding has two cases");
  if (json.contains("step")) {
    require(finding.content && json["step"] == finding.content->steps.size(), "its case has another number of steps");
  }
  if (json.contains("witness_format")) require(json["witness_format"] == kWitnessFormat, "an unknown witness_format");
  if (finding.minimized) {
    require(size_json(*finding.content, finding.minimized->size) == json.at("size"),
            "the size is not that of the case");
    require(guarantee_name(finding.minimized->guarantee) == json.at("guarantee"), "an unknown guarantee");
  }
}

void read_verdict(const Json& json, const CampaignFinding& finding, Details& details) {
  const Json& claims = json.at("claims");
  require(claims.is_object() && claims.size() <= 1, "a finding has verdicts on several claims");
  if (claims.empty()) return;
  require(claims.contains(finding.claim), "a finding has a verdict on another claim");
  const Verdict verdict = verdict_from_json(claims.at(finding.claim));
  require(verdict.outcome == asts::Outcome::violated, "a finding does not violate its claim");
  if (verdict.witness) require(kind_of(*verdict.witness) == finding.kind, "the witness is of another kind");
  details.witness = verdict.witness;
  details.met = count_in(claims.at(finding.claim), "met");
}

void read_minimization(const Json& json, Details& details) {
  if (json.contains("last_run")) {
    for (const Json& pass : json["last_run"]) {
      details.last_run.push_back(
          {text_in(pass, "pass"), count_in(pass, "evaluations"), pass.at("accepted").get<bool>()});
    }
  }
  if (!json.contains("others")) return;
  for (const Json& other : json["others"]) {
    const Case content = parse_case(text_in(other, "mesh"), "others");
    details.others.emplace_back(text_in(other, "kind"), write_case(content));
  }
}

Details details_from(const Json& json, const CampaignFinding& finding) {
  Details details;
  read_minimization(json, details);
  CampaignRecords::Origin origin{finding.number, finding.step, {}, {}, {}};
  for (const Details::Pass& pass : details.last_run) origin.last_evaluations += pass.evaluations;
  if (json.contains("evaluations")) {
    origin.evaluations = count_in(json, "evaluations");
    origin.guarantee = text_in(json, "guarantee");
  }
  details.origins.push_back(origin);
  if (json.contains("elements")) details.elements = count_in(json, "elements");
  read_verdict(json, finding, details);
  return details;
}

/// What does not depend on how a finding was found.
bool same_finding(const Details& one, const Details& other) {
  const auto witness = [](const Details& details) { return details.witness ? witness_json(*details.witness) : Json(); };
  return witness(one) == witness(other) && one.elements == other.elements && one.met == other.met;
}

bool same_words(const CampaignFinding& one, const CampaignFinding& other) {
  return one.says == other.says && one.valid == other.valid && one.validation == other.validation;
}

}  // namespace

void FindingDetails::add(const std::string& line, CampaignState& state) {
  const FindingRecord record = finding_from_json(line);
  const Json json = Json::parse(line);
  require_integer(json, "task");
  const CampaignFinding& finding = record.findings.front();
  require_agreement(json, finding);
  Details details = details_from(json, finding);
  for (std::size_t i = 1; i < record.findings.size(); ++i) require_name(record.findings[i]);
  state.add_finding(record);
  merge(finding, std::move(details));
  for (std::size_t i = 1; i < record.findings.size(); ++i) {
    Details spoiled;
    spoiled.origins.push_back({record.findings[i].number, record.findings[i].step, {}, {}, {}});
    merge(record.findings[i], std::move(spoiled));
  }
}

void FindingDetails::merge(const CampaignFinding& finding, Details details) {
  const std::string key = key_of(finding);
  const auto place = known_.find(key);
  if (place == known_.end()) {
    known_.emplace(key, Known{finding, std::move(details)});
    return;
  }
  Known& known = place->second;
  if (!same_finding(known.details, details) || !same_words(known.finding, finding)) {
    differences_.push_back("findings.jsonl: two records of " + finding_name(finding) + " contradict each other");
  }
  known.details.origins.insert(known.details.origins.end(), details.origins.begin(), details.origins.end());
}

std::vector<Details> FindingDetails::of(const std::vector<CampaignFinding>& findings) const {
  std::vector<Details> result;
  for (const CampaignFinding& finding : findings) result.push_back(known_.at(key_of(finding)).details);
  return result;
}

}  // namespace asts
