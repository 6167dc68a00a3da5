#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lib/mesh/case.hpp"
#include "properties/campaign/provocations.hpp"
#include "properties/claims/claim.hpp"

namespace asts {

/// A case of a collection, which is decided again before any random case.
struct StoredCase {
  std::string name;  ///< of its file, without the folder
  const Claim* claim;
  std::string kind;  ///< of the violation that it stands for; may be empty
  Case content;

  friend bool operator==(const StoredCase&, const StoredCase&) = default;
};

/// What a campaign tries. Equal plans give equal results, up to the number of cases.
struct CampaignPlan {
  std::string version;  ///< of the program: another one may decide otherwise
  std::vector<const Claim*> claims;
  bool named = false;  ///< somebody named the claims: they are expected to hold, refuted or not
  std::uint64_t seed = 1;
  std::int64_t minimize_budget = 5000;  ///< evaluations for each violation that is minimized
  std::vector<StoredCase> stored;

  friend bool operator==(const CampaignPlan&, const CampaignPlan&) = default;
};

/// The work of a campaign, numbered: first each claim that has something to try without a case, then the stored cases
/// as one unit if there are any, then the blocks of random cases without end.
struct Unit {
  enum class Kind { alone, stored, block };
  Kind kind;
  std::size_t place = 0;        ///< alone: of the claim
  std::int64_t first_case = 0;  ///< block
};

Unit unit_of(const CampaignPlan& plan, std::int64_t number);

/// How many units there are up to the random case `cases`.
std::int64_t units_for(const CampaignPlan& plan, std::int64_t cases);

inline constexpr const char* kStoredBias = "stored";
/// The kind of the finding that a stored case is violated no more.
inline constexpr const char* kNotViolated = "not-violated";

/// A case of a campaign, and what it was drawn to provoke.
struct CampaignCase {
  Case content;
  std::string bias;             ///< kStoredBias for a stored one
  const Claim* only = nullptr;  ///< the claim that it was drawn for, when it is to be tried on that one alone
};

/// The case of a number; below 0: -1 minus the place of a stored one. A pure function of the plan and the number.
CampaignCase campaign_case(const CampaignPlan& plan, std::int64_t number);

/// All biases that campaign_case may give, but for kStoredBias.
std::vector<std::string> campaign_biases(const CampaignPlan& plan);

}  // namespace asts
