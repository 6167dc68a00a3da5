#pragma once

#include <span>
#include <string>

#include "properties/campaign/summary.hpp"

namespace asts {

/// A campaign as JUnit XML, as junit-10.xsd has it: a suite with a test case for each claim (its class is the kind of
/// statement), for deaths outside of all claims, and for each health problem. Without times.
///
/// A claim with a finding that is not expected fails, with the case and the witness as text; with a death ("crash",
/// "timeout", "memory", "exception") it is an error; one whose hypothesis was never met is skipped. Expected findings
/// are told as output of a test case that passes. A health problem is an error. Each test case has one outcome.
std::string campaign_junit(const CampaignSummary& summary, std::span<const HealthProblem> problems);

}  // namespace asts
