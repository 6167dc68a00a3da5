#pragma once

#include <deque>
#include <map>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "fuzz/campaign/state.hpp"
#include "fuzz/campaign/worker.hpp"

namespace asts {

/// The units that were begun and are not recorded yet. Several are worked on at the same time; what is the same for any
/// number of workers is kept here: which meshes are new is settled in the order of the units, and so is what is
/// recorded.
class OpenUnits {
 public:
  /// Of random cases up to number `cases`. REQUIRES: plan and state outlive it.
  OpenUnits(const CampaignPlan& plan, const CampaignState& state, std::int64_t cases);

  std::int64_t next() const { return next_; }
  /// Begins the unit next().
  std::int64_t begin();
  /// A unit that has to be done again, because something in it did not come back.
  std::optional<std::int64_t> take_again();
  const UnitOrder& order(std::int64_t unit) const { return open_.at(unit).order; }

  /// What meshes a unit has. Then answers() says which of them no earlier unit has, as soon as that is known.
  void has_meshes(std::int64_t unit, std::vector<std::uint64_t> meshes) { waiting_[unit] = std::move(meshes); }
  std::vector<std::pair<std::int64_t, std::vector<bool>>> answers();

  void is_done(std::int64_t unit, UnitRecord record, UnitTimes times);
  /// The unit is to be done again without the claim on the case, or without the case when no claim was being tried.
  /// Where no case is to blame, or too many are, it is given up: nothing of it counts but that its meshes occurred.
  void has_died(std::int64_t unit, const UnitDeath& death);

  struct Complete {
    UnitRecord record;
    UnitTimes times;
  };
  /// The unit state.next_unit() when it is complete, for being recorded.
  std::optional<Complete> take_complete();

 private:
  struct OpenUnit {
    UnitOrder order;
    bool told = false;                 ///< which of its meshes are new is settled
    std::vector<std::uint64_t> fresh;  ///< these, in order
    std::unordered_set<std::uint64_t> is_fresh;
    std::vector<UnitDeath> deaths;
    std::optional<UnitRecord> record;  ///< when it is done
    UnitTimes times;
  };

  void tell(OpenUnit& unit, const std::vector<std::uint64_t>& meshes);
  void give_up(std::int64_t number);

  const CampaignPlan& plan_;
  const CampaignState& state_;
  std::int64_t cases_;
  std::int64_t next_;
  std::int64_t next_told_;
  std::map<std::int64_t, OpenUnit> open_;
  std::map<std::int64_t, std::vector<std::uint64_t>> waiting_;
  std::unordered_set<std::uint64_t> meshes_;  ///< that open units have first
  std::deque<std::int64_t> again_;
};

}  // namespace asts
