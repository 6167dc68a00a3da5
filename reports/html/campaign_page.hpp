#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "properties/campaign/summary.hpp"
#include "properties/witness.hpp"

namespace asts {

/// What a run directory of a campaign records, for a report. Every number of the page comes from here.
struct CampaignRecords {
  CampaignSummary summary;
  std::vector<HealthProblem> health;
  bool named = false;                ///< the claims were named: they were expected to hold
  std::int64_t cases_asked = 0;      ///< 0: as many as fit into a time
  std::int64_t minimize_budget = 0;  ///< evaluations for each violation
  std::int64_t findings_open = 0;    ///< what came up and was not worked out before the campaign ended
  std::vector<std::string> stored;   ///< names of the stored cases that were decided first

  /// What came up and led to a finding.
  struct Origin {
    std::optional<std::int64_t> number;  ///< as in CampaignFinding
    std::int64_t step = 0;
    std::optional<std::int64_t> evaluations;  ///< of its minimization
    std::int64_t last_evaluations = 0;        ///< of these in the last run of all passes
    std::string guarantee;                    ///< likewise; empty without
  };
  /// What is known of a finding beyond the summary's.
  struct Details {
    std::vector<Origin> origins;
    std::optional<Witness> witness;
    std::optional<std::int64_t> elements;
    std::optional<std::int64_t> met;
    struct Pass {
      std::string name;
      std::int64_t evaluations = 0;
      bool accepted = false;
    };
    std::vector<Pass> last_run;
    std::vector<std::pair<std::string, std::string>> others;  ///< kinds met on the way, and the smallest case of each
  };
  std::vector<Details> details;  ///< one for each finding of the summary, in its order

  /// A record of a unit of work.
  struct Unit {
    std::int64_t number = 0;
    std::string what;  ///< "cases 0 to 63"
    std::int64_t cases = 0;
    std::int64_t meshes = 0;
    std::int64_t distinct = 0;
    std::int64_t trivial = 0;
    std::int64_t sequences = 0;
    std::vector<std::string> events;  ///< violations and deaths, in words
  };
  std::vector<Unit> units;

  /// How long a unit took, in microseconds.
  struct Times {
    std::int64_t unit = 0;
    std::int64_t total = 0;
    std::int64_t slowest = 0;          ///< of its cases
    std::int64_t slowest_number = 0;   ///< which case that was
    std::vector<std::int64_t> claims;  ///< in the order of the summary's
  };
  std::vector<Times> times;  ///< may be missing: nothing depends on it

  /// Where files of the directory do not say what its records say.
  std::vector<std::string> differences;
};

/// The report of a campaign: one HTML page that needs no other file. Depends on the arguments alone. `version` is that
/// of the program that draws the pictures.
/// Cost: that of the pictures, one or a few for each finding with a case. Throws InputError for a case that cannot be
/// replayed.
std::string campaign_page(const CampaignRecords& records, const std::string& version);

}  // namespace asts
