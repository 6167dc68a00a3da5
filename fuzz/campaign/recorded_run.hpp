#pragma once

#include <string>

#include "reports/html/campaign_page.hpp"

namespace asts {

/// Whether a folder is, or was to be, the run directory of a campaign: it has units.jsonl.
bool has_campaign(const std::string& folder);

/// Everything that a run directory of a campaign records, read strictly: a line that is cut off, damaged, or of another
/// shape than the campaign writes is an error, unlike for a campaign that goes on. Where statistics.json or the file
/// of a finding is missing or does not say what the records say, `differences` says so.
/// Throws InputError "FILE:LINE: reason", or "FILE: reason" where no line is at fault.
/// Law (tests/fuzz/recorded_run_test.cpp): two directories that differ in a number of a record differ here.
CampaignRecords read_recorded_run(const std::string& folder);

}  // namespace asts
