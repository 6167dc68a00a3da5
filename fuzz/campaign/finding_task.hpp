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
};

FindingTask task_of(std::int64_t index, const UnitViolation& violation);
FindingTask task_of(std::int64_t index, const UnitDeath& death);

/// Makes the finding: minimizes the case, has the witness decided by the literal code. A JSON object without a line
/// end, which `asts validate` reads. `evaluated` is called before each evaluation.
/// A pure function of plan and task, as far as the code under test is.
std::string work_out(const CampaignPlan& plan, const FindingTask& task, const std::function<void()>& evaluated);

/// The finding of a task whose own working out did not come back, as it was drawn.
std::string unminimized(const CampaignPlan& plan, const FindingTask& task, const std::string& why);

/// A finding, and whose it is.
struct FindingRecord {
  std::int64_t task = 0;
  CampaignFinding finding;
};

/// Reads what work_out() wrote. Throws InputError for what is none.
FindingRecord finding_from_json(std::string_view text);

}  // namespace asts
