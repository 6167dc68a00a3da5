#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_set>
#include <vector>

#include "lib/mesh/fingerprint.hpp"
#include "properties/ledger/trials.hpp"

namespace asts {

/// What a run of the ledger tries.
struct LedgerPlan {
  std::vector<const Claim*> claims;
  std::uint64_t seed = 1;
  Extent extent = Extent::short_run;
  /// Random cases for each claim, instead of what the extent gives it.
  std::optional<std::int64_t> cases;
  /// A run can be split: share number `share` of `shares` has the settings, and the trials without a mesh, that fall to
  /// it. Distinct meshes of different shares are distinct.
  int share = 0;
  int shares = 1;
};

/// How many random cases a claim is tried on.
std::int64_t cases_for(const Claim& claim, Extent extent);

/// The run: random cases are made once and handed to all claims that want them.
///
/// A case of steps gives a mesh after each step, and the whole sequence. A mesh that occurred before is left out, so
/// that every mesh is tried once, by the claims that Trials chooses. Sequences of `refine` steps go to on_sequence.
///
/// Laws (tests/properties/ledger_test.cpp): (1) the same plan gives the same records; (2) the merged records of all
/// shares are the records of the whole, however many shares there are.
class Ledger {
 public:
  /// `describe` gives the words for a violation.
  Ledger(LedgerPlan plan, std::string (*describe)(const Verdict&));
  Ledger(const Ledger&) = delete;
  Ledger& operator=(const Ledger&) = delete;

  /// Called before each piece of work, for progress: what is tried, a claim's id or "cases", and how much of it is
  /// done. May throw, which ends the run: the records stay.
  using Watch = std::function<void(const char* what, std::int64_t done, std::int64_t total)>;

  void run(const Watch& watch);

  /// In the order of the plan's claims.
  const std::vector<LedgerRecord>& records() const { return trials_.records(); }
  /// The time that each claim took, in that order: for setting Claim::stride, not for results.
  const std::vector<std::chrono::nanoseconds>& times() const { return trials_.times(); }

 private:
  bool has_cases_for(std::size_t place, std::int64_t number) const { return number < cases_[place]; }
  void try_case(std::int64_t number);
  void try_mesh(TrialSubject& subject, MeshUnderTest& mesh);

  LedgerPlan plan_;
  std::vector<std::int64_t> cases_;
  std::int64_t number_ = 0;  ///< of the case that is being tried
  Trials trials_;
  std::unordered_set<Fingerprint, FingerprintHash> seen_;
};

}  // namespace asts
