#include "properties/campaign/health.hpp"

#include "lib/exact/rational.hpp"
#include "lib/gen/random_case.hpp"
#include "properties/campaign/provocations.hpp"

namespace asts {

namespace {

// Measured on the stream of cases: of the distinct meshes 20 to 25 in 100 are initial meshes after 64 cases, 13 after
// 1000, 6 after 20,000. More than half come from another stream, or from a generator that no longer refines.
constexpr std::int64_t kMeshesToJudgeTrivial = 100;
constexpr std::int64_t kTrivialPart = 2;

// Of all meshes 84 in 100 are new after 1000 cases, 71 after 20,000, 54 after 650,000: the smallest settings are used
// up first. Fewer than one in four would need a stream of far fewer settings.
constexpr std::int64_t kMeshesToJudgeRepeated = 1000;
constexpr std::int64_t kDistinctPart = 4;

/// A bias is said to be missing when chance would explain that less often than once in so many campaigns.
constexpr std::int64_t kChance = 1'000'000;

// A case of 10 seconds holds up nobody who lets a campaign run for an hour; one part in 10 of the time does. Costs are
// uneven: of 1000 cases of the stream the slowest took 7 parts in 100.
constexpr std::int64_t kSlowMicroseconds = 10'000'000;
constexpr std::int64_t kTimePart = 10;
constexpr std::int64_t kTimesMean = 2;

std::string of_all(std::int64_t part, std::int64_t all, const char* what) {
  return std::to_string(part) + " of " + std::to_string(all) + " " + what;
}

void check_meshes(const CampaignSummary& summary, std::vector<HealthProblem>& problems) {
  if (summary.distinct >= kMeshesToJudgeTrivial && kTrivialPart * summary.trivial > summary.distinct) {
    problems.push_back(
        {"trivial-meshes", "",
         of_all(summary.trivial, summary.distinct, "distinct meshes are initial meshes, more than one in ") +
             std::to_string(kTrivialPart)});
  }
  if (summary.meshes >= kMeshesToJudgeRepeated && kDistinctPart * summary.distinct < summary.meshes) {
    problems.push_back({"repeated-meshes", "",
                        of_all(summary.distinct, summary.meshes, "meshes are distinct, fewer than one in ") +
                            std::to_string(kDistinctPart)});
  }
}

void check_claims(const CampaignSummary& summary, std::vector<HealthProblem>& problems) {
  for (const LedgerRecord& record : summary.records) {
    if (record.trials() == 0) {
      problems.push_back({"never-tried", record.claim, "no case is one that the claim can be tried on"});
    }
  }
  for (const LedgerRecord& record : summary.records) {
    if (record.trials() == 0 || record.result() != LedgerResult::undecided) continue;
    problems.push_back({"hypothesis-never-met", record.claim,
                        "its hypothesis was met in none of " + std::to_string(record.trials()) + " trials"});
  }
}

/// Whether that many independent draws miss what has the probability 1/n each less often than once in kChance times:
/// ((n-1)/n)^draws < 1/kChance.
bool is_no_chance(std::int64_t n, std::int64_t draws) {
  Integer missed = 1;
  Integer all = 1;
  for (std::int64_t draw = 0; draw < draws; ++draw) {
    missed *= n - 1;
    all *= n;
    if (missed * kChance < all) return true;
  }
  return false;
}

std::int64_t count_of(const CampaignSummary& summary, const char* bias) {
  const auto found = summary.biases.find(bias);
  return found == summary.biases.end() ? 0 : found->second;
}

void check_biases(const CampaignSummary& summary, std::vector<HealthProblem>& problems) {
  const auto check = [&](const char* name, std::int64_t one_in, std::int64_t draws, const char* of_what) {
    const auto found = summary.biases.find(name);
    if (found == summary.biases.end() || found->second > 0 || !is_no_chance(one_in, draws)) return;
    problems.push_back({"bias-never-fired", name, "no case was drawn for it in " + std::to_string(draws) + of_what});
  };
  // neither stored cases nor provoked ones are draws of a bias
  std::int64_t drawn = 0;
  std::int64_t provoked = 0;
  for (const Bias bias : all_biases()) drawn += count_of(summary, bias_name(bias));
  for (const Provocation& one : all_provocations()) provoked += count_of(summary, one.name);
  const auto count = static_cast<std::int64_t>(all_biases().size());
  for (const Bias bias : all_biases()) check(bias_name(bias), count, drawn, " draws of a bias");
  for (const Provocation& one : all_provocations()) {
    check(one.name, one.rarity, (drawn + provoked) / kBlockCases, " blocks of cases");
  }
}

}  // namespace

std::vector<HealthProblem> check_health(const CampaignSummary& summary) {
  std::vector<HealthProblem> problems;
  check_meshes(summary, problems);
  check_claims(summary, problems);
  check_biases(summary, problems);
  return problems;
}

std::optional<HealthProblem> check_speed(const CaseTimes& times) {
  const Integer slowest = times.slowest;
  const bool slow = times.slowest > kSlowMicroseconds && slowest * kTimePart > times.total &&
                    slowest * times.cases > Integer(times.total) * kTimesMean;
  if (!slow) return std::nullopt;
  return HealthProblem{"slow-case", std::to_string(times.slowest_number),
                       "case " + std::to_string(times.slowest_number) + " took " + std::to_string(times.slowest) +
                           " of " + std::to_string(times.total) + " microseconds for " + std::to_string(times.cases) +
                           " cases"};
}

}  // namespace asts
