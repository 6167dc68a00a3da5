#pragma once

#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "fuzz/campaign/unit_record.hpp"
#include "properties/ledger/trials.hpp"
#include "properties/statement.hpp"

namespace asts {

/// What is told while a unit is worked on, so that somebody else knows what it was that did not come back.
struct UnitWatch {
  /// Before a case is made (step -1), and before anything is done with the mesh after so many of its steps.
  std::function<void(std::int64_t number, std::int64_t step)> at_mesh;
  /// Before a claim is tried.
  std::function<void(const Claim& claim)> at_claim;
};

/// What is left out, because it did not come back: a claim on the meshes of a case, or, without a claim, the case.
struct Skip {
  std::int64_t number = 0;
  std::string claim;

  friend bool operator==(const Skip&, const Skip&) = default;
};

/// Times of a unit, in microseconds, of the processor but for `claims`: for people and health checks, never for
/// results.
struct UnitTimes {
  std::int64_t total = 0;
  std::int64_t slowest = 0;          ///< of its cases
  std::int64_t slowest_number = 0;   ///< which case that was
  std::vector<std::int64_t> claims;  ///< in the plan's order, as the clock on the wall has it
};

/// A case of a unit and its meshes.
struct MadeCase {
  std::int64_t number;
  CampaignCase made;
  std::int64_t microseconds = 0;  ///< that it took to make it
  /// Of each step, from step 0 on: its place among the unit's meshes. Empty when it was drawn for a claim about
  /// sequences.
  std::vector<std::size_t> meshes;
};

/// The work on one unit, in two parts: first what meshes there are, then, told which of them no earlier unit had, the
/// trials. So every mesh of a campaign is tried once, and results depend on the order of the units alone.
class UnitWork {
 public:
  /// Makes the cases and their meshes: random cases up to number `cases`, without what is skipped.
  UnitWork(const CampaignPlan& plan, std::int64_t unit, std::int64_t cases, std::vector<Skip> skipped, UnitWatch watch);

  /// For each mesh 64 bits that stand for it, each once, in the order in which they occur: the low word of its
  /// fingerprint. In a case that was drawn for one claim a mesh is another one than in the stream, as it is tried on
  /// that claim alone.
  const std::vector<std::uint64_t>& meshes() const { return meshes_; }

  /// Tries the claims on meshes for which `fresh` says that they occur for the first time. All of the record is set but
  /// `fresh` and `deaths`. REQUIRES: called once, fresh.size() == meshes().size().
  UnitRecord try_fresh(std::vector<bool> fresh);
  /// REQUIRES: try_fresh() was called.
  const UnitTimes& times() const { return times_; }

 private:
  void make_case(std::int64_t number);
  bool skips(std::int64_t number, std::string_view claim) const;
  std::size_t place_of(std::uint64_t mesh);
  void decide_again(std::int64_t number);
  void try_case(const MadeCase& made, Trials& trials);
  void try_sequence(TrialSubject& subject, Trials& trials);
  void try_mesh(TrialSubject& subject, MeshUnderTest& mesh, std::size_t place, Trials& trials);
  void count_mesh(const MeshUnderTest& mesh);
  void count_violation(std::size_t place, const TrialSubject* subject, const Verdict& verdict);
  void finish(const Trials& trials);

  const CampaignPlan& plan_;
  Unit unit_;
  std::vector<Skip> skipped_;
  UnitWatch watch_;
  std::int64_t number_ = 0;           ///< of the case that is being tried
  std::vector<std::int64_t> stored_;  ///< numbers
  std::vector<MadeCase> made_;
  std::vector<std::uint64_t> meshes_;
  std::unordered_map<std::uint64_t, std::size_t> places_;  ///< of a mesh in meshes_
  std::vector<bool> fresh_;                                ///< and not tried yet
  std::map<std::pair<std::size_t, std::string>, UnitViolation> violations_;
  UnitRecord record_;
  UnitTimes times_;
};

}  // namespace asts
