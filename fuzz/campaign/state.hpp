#pragma once

#include <array>
#include <map>
#include <string>
#include <unordered_set>

#include "fuzz/campaign/finding_task.hpp"
#include "fuzz/campaign/unit_record.hpp"

namespace asts {

/// What a campaign knows so far: a function of the records of its units in their order, and of the findings in theirs.
class CampaignState {
 public:
  explicit CampaignState(const CampaignPlan& plan);

  /// Takes the record of the next unit. Throws InputError when it is that of another one.
  void add_unit(const UnitRecord& record);
  /// Takes the finding of the next task. Throws InputError when it is that of another one, or there is none.
  void add_finding(const FindingRecord& record);

  std::int64_t next_unit() const { return next_unit_; }
  /// What has come up so far. Of the units that violate a claim in one way, and of the deaths with one first line, the
  /// first, second, fourth, eighth, ... give a task: often enough to meet different cases, seldom enough for claims
  /// that every mesh violates. Every stored case that is otherwise than recorded gives one.
  const std::vector<FindingTask>& tasks() const { return tasks_; }
  std::size_t next_finding() const { return findings_done_; }

  /// Whether the mesh occurs in no unit so far.
  bool is_new(std::uint64_t mesh) const { return !meshes_.contains(mesh); }

  /// How many random cases there were.
  std::int64_t cases() const { return summary_.cases; }
  const CampaignSummary& summary() const { return summary_; }
  /// Claims of which the hypothesis was met.
  std::int64_t claims_met() const;

 private:
  template <typename Event>
  void add_task(const Event& event, const std::string& details);

  const CampaignPlan& plan_;
  std::int64_t next_unit_ = 0;
  std::vector<FindingTask> tasks_;
  std::size_t findings_done_ = 0;
  std::unordered_set<std::uint64_t> meshes_;
  std::map<std::array<std::string, 3>, std::int64_t> events_;  ///< by claim, kind and details
  std::map<std::string, std::size_t> places_;                  ///< of claims, by id
  std::unordered_set<std::string> known_;                      ///< claim, kind and case of findings
  CampaignSummary summary_;
};

}  // namespace asts
