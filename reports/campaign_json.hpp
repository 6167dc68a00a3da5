#pragma once

#include <span>
#include <string>

#include "properties/campaign/summary.hpp"

namespace asts {

/// The contents of statistics.json: one object with everything of the summary and the health problems, indented by two
/// blanks, keys in a fixed order, with a line end. Bytes that are no UTF-8 are replaced by U+FFFD.
std::string campaign_json(const CampaignSummary& summary, std::span<const HealthProblem> problems);

}  // namespace asts
