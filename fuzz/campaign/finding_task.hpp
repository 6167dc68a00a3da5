#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "fuzz/campaign/plan.hpp"
#include "fuzz/campaign/unit_record.hpp"
#include "properties/campaign/summary.hpp"

namespace asts {

/// A violation or a death that is to be made a finding.
struct FindingTask {
  std::int64_t index = 0;  ///< in the order in which tasks come up
  std::string claim;
  std::string kind;
  std::optional<std::int64_t> number;
  std::int64_t step = 0;
  std::string says;
  bool died = false;
  /// What happened while it was worked out before, if that did not come back: then the case stays as it was drawn.
  std::optional<UnitDeath> spoiled;
  std::string spoiled_by;  ///< the case that was being tried then, as text; may be empty
};

/// In a run directory: of violations, and of code that did not come back.
inline constexpr const char* kFindingFolder = "findings";
inline constexpr const char* kDeathFolder = "deaths";

FindingTask task_of(std::int64_t index, const UnitViolation& violation);
FindingTask task_of(std::int64_t index, const UnitDeath& death);

/// Told before each piece of work on a finding: the case that is tried.
using TaskWatch = std::function<void(const Case& tried)>;

/// Makes the finding: minimizes the case, has the witness decided by the literal code. A JSON object without a line
/// end, which `asts validate` reads. A death is tried again in processes of its own, each for `timeout_seconds` at
/// most. A pure function of plan and task, as far as the code under test is.
std::string work_out(const CampaignPlan& plan, const FindingTask& task, std::int64_t timeout_seconds,
                     const TaskWatch& watch);

/// The finding of a task without trying anything: its case as it was drawn, and what spoiled its working out.
std::string as_drawn(const CampaignPlan& plan, const FindingTask& task);

/// What a task gave: its finding, and another one if working it out was spoiled.
struct FindingRecord {
  std::int64_t task = 0;
  std::vector<CampaignFinding> findings;
};

/// Reads what work_out() wrote. Throws InputError for what is none.
FindingRecord finding_from_json(std::string_view text);

}  // namespace asts
