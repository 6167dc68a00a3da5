#include "fuzz/campaign/plan.hpp"

#include <algorithm>

#include "lib/gen/case_stream.hpp"
#include "properties/campaign/provocations.hpp"

namespace asts {

namespace {

std::vector<std::size_t> places_alone(const CampaignPlan& plan) {
  std::vector<std::size_t> places;
  for (std::size_t place = 0; place < plan.claims.size(); ++place) {
    if (plan.claims[place]->alone != nullptr) places.push_back(place);
  }
  return places;
}

bool any_on_cases(const CampaignPlan& plan) {
  return std::any_of(plan.claims.begin(), plan.claims.end(),
                     [](const Claim* claim) { return claim->on_mesh != nullptr || claim->on_sequence != nullptr; });
}

bool has_claim(const CampaignPlan& plan, std::string_view id) {
  return std::any_of(plan.claims.begin(), plan.claims.end(), [id](const Claim* claim) { return claim->id == id; });
}

/// The last cases of a block are those that are drawn for single claims: what the case is drawn for, if it is.
const Provocation* provocation_of(const CampaignPlan& plan, std::int64_t number) {
  const std::int64_t block = number / kBlockCases;
  std::int64_t end = kBlockCases - number % kBlockCases;  // cases from this one to the end of the block
  int place = 0;
  for (const Provocation& provocation : all_provocations()) {
    if (block % provocation.rarity != place++ % provocation.rarity || !has_claim(plan, provocation.claim)) continue;
    end -= provocation.cases;
    if (end <= 0) return &provocation;
  }
  return nullptr;
}

/// The units before the first block.
std::int64_t units_before(const CampaignPlan& plan) {
  return static_cast<std::int64_t>(places_alone(plan).size()) + (plan.stored.empty() ? 0 : 1);
}

}  // namespace

Unit unit_of(const CampaignPlan& plan, std::int64_t number) {
  const std::vector<std::size_t> alone = places_alone(plan);
  if (number < static_cast<std::int64_t>(alone.size())) {
    return {Unit::Kind::alone, alone[static_cast<std::size_t>(number)]};
  }
  const std::int64_t before = units_before(plan);
  if (number < before) return {Unit::Kind::stored};
  return {Unit::Kind::block, 0, (number - before) * kBlockCases};
}

std::int64_t units_for(const CampaignPlan& plan, std::int64_t cases) {
  return units_before(plan) + (any_on_cases(plan) ? (cases + kBlockCases - 1) / kBlockCases : 0);
}

CampaignCase campaign_case(const CampaignPlan& plan, std::int64_t number) {
  if (number < 0) return {plan.stored.at(static_cast<std::size_t>(-1 - number)).content, kStoredBias};
  PlannedCase planned = plan_case(plan.seed, number);
  if (const Provocation* provocation = provocation_of(plan, number)) {
    return {provocation->draw(planned.draw), provocation->name, find_claim(provocation->claim)};
  }
  RandomCase random = make_case(std::move(planned));
  return {std::move(random.content), bias_name(random.bias)};
}

std::vector<std::string> campaign_biases(const CampaignPlan& plan) {
  std::vector<std::string> names;
  for (const Bias bias : all_biases()) names.emplace_back(bias_name(bias));
  for (const Provocation& provocation : all_provocations()) {
    if (has_claim(plan, provocation.claim)) names.emplace_back(provocation.name);
  }
  return names;
}

}  // namespace asts
