#include "fuzz/campaign/open_units.hpp"

#include <algorithm>

namespace asts {

namespace {

/// Code that does not come back more often in one unit is of no use in the others either.
constexpr std::size_t kMostDeaths = 128;

}  // namespace

OpenUnits::OpenUnits(const CampaignPlan& plan, const CampaignState& state, std::int64_t cases)
    : plan_(plan), state_(state), cases_(cases), next_(state.next_unit()), next_told_(next_) {}

std::int64_t OpenUnits::begin() {
  open_[next_].order = {next_, cases_, {}};
  return next_++;
}

std::optional<std::int64_t> OpenUnits::take_again() {
  if (again_.empty()) return std::nullopt;
  const std::int64_t unit = again_.front();
  again_.pop_front();
  return unit;
}

// A unit that is done again keeps what it was told: then its turn was before.
std::vector<std::pair<std::int64_t, std::vector<bool>>> OpenUnits::answers() {
  std::vector<std::pair<std::int64_t, std::vector<bool>>> result;
  while (!waiting_.empty() && waiting_.begin()->first <= next_told_) {
    const auto [number, meshes] = *waiting_.begin();
    waiting_.erase(waiting_.begin());
    OpenUnit& unit = open_.at(number);
    if (!unit.told) tell(unit, meshes);
    std::vector<bool>& fresh = result.emplace_back(number, std::vector<bool>()).second;
    for (const std::uint64_t mesh : meshes) fresh.push_back(unit.is_fresh.contains(mesh));
  }
  return result;
}

void OpenUnits::tell(OpenUnit& unit, const std::vector<std::uint64_t>& meshes) {
  for (const std::uint64_t mesh : meshes) {
    if (state_.is_new(mesh) && meshes_.insert(mesh).second) unit.fresh.push_back(mesh);
  }
  unit.is_fresh.insert(unit.fresh.begin(), unit.fresh.end());
  unit.told = true;
  for (auto told = open_.find(next_told_); told != open_.end() && told->second.told; ++told) ++next_told_;
}

void OpenUnits::is_done(std::int64_t unit, UnitRecord record, UnitTimes times) {
  open_.at(unit).record = std::move(record);
  open_.at(unit).times = std::move(times);
}

void OpenUnits::has_died(std::int64_t unit, const UnitDeath& death) {
  waiting_.erase(unit);
  OpenUnit& open = open_.at(unit);
  std::vector<Skip>& skipped = open.order.skipped;
  open.deaths.push_back(death);
  const Skip skip{death.number.value_or(0), death.claim};
  const bool tried_before = std::find(skipped.begin(), skipped.end(), skip) != skipped.end();
  if (!death.number || tried_before || open.deaths.size() > kMostDeaths) return give_up(unit);
  skipped.push_back(skip);
  again_.push_back(unit);
}

void OpenUnits::give_up(std::int64_t number) {
  OpenUnit& unit = open_.at(number);
  if (!unit.told) tell(unit, {});
  unit.record.emplace().unit = number;
  const Unit what = unit_of(plan_, number);
  if (what.kind == Unit::Kind::block) unit.record->end = std::min(what.first_case + kBlockCases, cases_);
}

std::optional<OpenUnits::Complete> OpenUnits::take_complete() {
  const auto first = open_.find(state_.next_unit());
  if (first == open_.end() || !first->second.record) return std::nullopt;
  OpenUnit& unit = first->second;
  unit.record->fresh = std::move(unit.fresh);
  unit.record->deaths = std::move(unit.deaths);
  for (const std::uint64_t mesh : unit.record->fresh) meshes_.erase(mesh);
  Complete complete{std::move(*unit.record), std::move(unit.times)};
  open_.erase(first);
  return complete;
}

}  // namespace asts
