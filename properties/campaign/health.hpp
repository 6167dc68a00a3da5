#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "properties/campaign/summary.hpp"

namespace asts {

/// What makes a campaign's good result hollow, in the order of the list below, within each by claim or bias as in the
/// summary:
///  "trivial-meshes"        most distinct meshes are initial meshes, about which most claims say nothing;
///  "repeated-meshes"       few of the meshes that were made are new: the cases do not differ enough;
///  "never-tried"           a claim that got no trial;
///  "hypothesis-never-met"  a claim that got trials, none of which says anything about it;
///  "bias-never-fired"      a bias of the summary with the count 0, when there is less than one chance in a million
///                          that so many cases miss it. Biases that the summary does not have are not asked about.
/// The two about claims do not ask for how long the campaign ran: one that is too short for a claim has not tested it,
/// and must not look as if it had. The others keep silent about campaigns that are too short to tell: fewer than 100
/// distinct meshes, 1000 meshes, and the chance for a bias.
///
/// Pure; depends on the summary alone. Law (tests/properties/campaign_health_test.cpp): the stream of cases of
/// lib/gen/case_stream is healthy.
std::vector<HealthProblem> check_health(const CampaignSummary& summary);

/// How long cases took, in whole microseconds.
struct CaseTimes {
  std::int64_t cases = 0;
  std::int64_t total = 0;
  std::int64_t slowest = 0;
  std::int64_t slowest_number = 0;  ///< of the case that took longest
};

/// "slow-case": a case took more than 10 seconds, more than one part in 10 of the time of all cases and more than twice
/// the mean. Depends on the machine, unlike the rest: it is no part of a campaign's results.
std::optional<HealthProblem> check_speed(const CaseTimes& times);

}  // namespace asts
