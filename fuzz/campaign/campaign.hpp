#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "fuzz/campaign/run_directory.hpp"
#include "fuzz/campaign/worker.hpp"
#include "properties/campaign/health.hpp"

namespace asts {

/// How a campaign is run: nothing here changes what it finds in a number of cases.
struct CampaignRun {
  std::int64_t cases = 0;                    ///< how many random cases; 0: as many as fit into the time
  std::optional<std::chrono::seconds> time;  ///< after which no block is begun
  int jobs = 1;                              ///< workers at the same time
  WorkerLimits limits;
  std::function<bool()> stop;                             ///< asked often; true ends the campaign as soon as possible
  std::function<void(const std::string& line)> progress;  ///< a line for a person, a few times a second
};

struct CampaignResult {
  CampaignSummary summary;
  CaseTimes times;  ///< of this run alone
  bool interrupted = false;
};

/// Runs a campaign, and records it in a folder if there is one; goes on where the folder's records end. The summary
/// depends on the plan and the number of cases that were done alone: not on jobs, interrupts and resumes, nor, as far
/// as each case either always comes back within its limits or never does, on the machine.
/// REQUIRES: this process has no other threads; the folder has begun this plan, or none.
/// Throws ResourceError when no process can be started or the folder cannot be written.
/// Laws: (1) any number of jobs gives the same summary and the same files (tests/fuzz/campaign_test.cpp,
/// run_directory_test.cpp); (2) so does a campaign that is killed at any moment and resumed (run_directory_test.cpp);
/// (3) a claim that crashes, hangs, throws or takes too much memory on a case is a finding, and everything else is
/// tried (campaign_test.cpp); (4) each distinct mesh of the stream is tried once by each claim that wants it, and once
/// more by a claim for which a case with it was drawn (unit_record_test.cpp).
CampaignResult run_campaign(const CampaignPlan& plan, const CampaignRun& run, RunDirectory* folder);

}  // namespace asts
