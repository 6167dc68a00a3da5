#pragma once

#include <span>
#include <string>

#include "properties/campaign/summary.hpp"

namespace asts {

/// A campaign as SARIF 2.1.0: a rule for each claim (and one for deaths outside of all claims), a result for each
/// finding. Places are the findings' files, relative to the run directory. Unexpected findings have the level error,
/// expected ones note. Health problems are notifications of an invocation that was not successful. Fingerprints are
/// made of claim, kind and case, so that a finding is known again in the next campaign.
std::string campaign_sarif(const CampaignSummary& summary, std::span<const HealthProblem> problems);

}  // namespace asts
