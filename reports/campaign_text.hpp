#pragma once

#include <span>
#include <string>

#include "properties/campaign/summary.hpp"

namespace asts {

/// For a person: what was tried and how much, a table of claims, what was found (each with its file), what the health
/// checks say. Lines end with a line feed.
std::string campaign_text(const CampaignSummary& summary, std::span<const HealthProblem> problems);

/// One finding: how large it is and how sure that is, where it comes from, what the literal code says of it, and the
/// witness in words.
std::string finding_text(const CampaignFinding& finding);

/// What the case is a finding of, in a line without its end: "as-implies-dc: no-partial-overlap".
std::string finding_name(const CampaignFinding& finding);

/// Whether the code under test did not end as it should: kDeathKinds.
bool is_death(const CampaignFinding& finding);

}  // namespace asts
