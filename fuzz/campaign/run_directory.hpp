#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fuzz/campaign/journal.hpp"
#include "fuzz/campaign/state.hpp"
#include "fuzz/campaign/unit_work.hpp"

namespace asts {

/// A campaign's folder. Journals of sealed lines (journal.hpp), each complete or not there at all:
///   units.jsonl     first the plan, then a record for each unit, in their order;
///   findings.jsonl  the findings, in theirs; `asts validate` reads them;
///   times.jsonl     how long units took: for people; nothing else depends on it.
/// Besides the cases of findings, findings/*.case and deaths/*.case, and what the caller writes. All of it is a
/// function of the plan and the number of cases, but for times.jsonl and lock.
class RunDirectory {
 public:
  /// Makes the folder if there is none, and locks it. Throws InputError when it cannot be written, when another program
  /// uses it, or, unless `resume`, when it has a campaign already.
  RunDirectory(std::string folder, bool resume);

  /// The plan that was begun here, when its record is complete. `cases` is how many were asked for; 0: a time.
  struct Begun {
    CampaignPlan plan;
    std::int64_t cases = 0;
  };
  const std::optional<Begun>& begun() const { return begun_; }

  /// Gives the state what is recorded, as far as it belongs to a campaign of `cases` cases: a last block that has fewer
  /// than it now should is done again. Records that this makes void are removed. REQUIRES: `begun` has the plan.
  /// Throws InputError when the records are not those of this plan.
  void restore(CampaignState& state, std::int64_t cases);
  /// Begins a campaign. REQUIRES: none was begun.
  void begin(const CampaignPlan& plan, std::int64_t cases);

  void add_unit(const std::string& object) { units_->append(object); }
  void add_finding(const std::string& object, const std::vector<CampaignFinding>& findings);
  void add_times(std::int64_t unit, const UnitTimes& times);
  void write_file(const std::string& name, const std::string& content) const;

 private:
  void write_case_of(const CampaignFinding& finding) const;
  std::string path(const char* name) const { return folder_ + "/" + name; }
  void open_journals(std::uint64_t units_end, std::uint64_t findings_end);

  std::string folder_;
  std::unique_ptr<FolderLock> lock_;
  std::optional<Begun> begun_;
  std::unique_ptr<Journal> units_;
  std::unique_ptr<Journal> findings_;
  std::unique_ptr<Journal> times_;
};

/// The plan of the first line; as it was written. Throws InputError for what is none.
RunDirectory::Begun begun_from_json(const std::string& line);

/// The state that a folder records, for reading alone. Nothing when not even the plan is complete.
/// Throws InputError when the folder is none of a campaign, or damaged.
struct RecordedCampaign {
  CampaignPlan plan;
  CampaignSummary summary;
};
std::optional<RecordedCampaign> read_campaign(const std::string& folder);

}  // namespace asts
