#include "fuzz/campaign/state.hpp"

#include <algorithm>
#include <bit>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts {

namespace {

void add(std::map<std::string, std::int64_t>& into, const std::map<std::string, std::int64_t>& other) {
  for (const auto& [name, count] : other) into[name] += count;
}

/// Equal for findings that are the same thing found again.
std::string key_of(const CampaignFinding& finding) {
  const std::string what = finding.content ? write_case(*finding.content) : finding.says;
  return finding.claim + '\n' + finding.kind + '\n' + what;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

CampaignState::CampaignState(const CampaignPlan& plan) : plan_(plan) {
  summary_.version = plan.version;
  summary_.seed = plan.seed;
  for (const Claim* claim : plan.claims) {
    places_[claim->id] = summary_.records.size();
    summary_.claims.emplace_back(claim->id);
    summary_.records.emplace_back().claim = claim->id;
  }
  for (const std::string& bias : campaign_biases(plan)) summary_.biases[bias] = 0;
}

void CampaignState::add_unit(const UnitRecord& record) {
  require(record.unit == next_unit_, "a unit is missing");
  ++next_unit_;
  if (unit_of(plan_, record.unit).kind == Unit::Kind::block) summary_.cases += record.cases;
  summary_.meshes += record.meshes;
  summary_.distinct += static_cast<std::int64_t>(record.fresh.size());
  summary_.trivial += record.trivial;
  summary_.sequences += record.sequences;
  for (const std::uint64_t mesh : record.fresh)
    require(meshes_.insert(mesh).second, "a mesh occurs for the first time twice");
  add(summary_.biases, record.biases);
  for (const auto& [what, counts] : record.generated) {
    for (const auto& [value, count] : counts) summary_.generated[what][value] += count;
  }
  for (const auto& [claim, one] : record.records) {
    require(places_.contains(claim), "a claim is not of this campaign");
    merge(summary_.records[places_.at(claim)], one);
  }
  for (const UnitViolation& violation : record.violations) add_task(violation, "");
  for (const UnitDeath& death : record.deaths) add_task(death, first_line(death.says));
  summary_.deaths += static_cast<std::int64_t>(record.deaths.size());
}

template <typename Event>
void CampaignState::add_task(const Event& event, const std::string& details) {
  const std::int64_t events = ++events_[{event.claim, event.kind, details}];
  const bool stored = event.number.value_or(0) < 0;
  if (!stored && !std::has_single_bit(static_cast<std::uint64_t>(events))) return;
  tasks_.push_back(task_of(static_cast<std::int64_t>(tasks_.size()), event));
}

void CampaignState::add_finding(const FindingRecord& record) {
  require(findings_done_ < tasks_.size() && record.task == static_cast<std::int64_t>(findings_done_),
          "a finding of no task");
  ++findings_done_;
  for (const CampaignFinding& finding : record.findings) {
    if (known_.insert(key_of(finding)).second) summary_.findings.push_back(finding);
  }
}

std::int64_t CampaignState::claims_met() const {
  return std::count_if(summary_.records.begin(), summary_.records.end(),
                       [](const LedgerRecord& record) { return record.met > 0; });
}

}  // namespace asts
