#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "lib/mesh/case.hpp"
#include "properties/claims/claim.hpp"

namespace asts {

/// How far the cases went on which a claim was tried and said something: the largest of each, 0 when there was none.
struct LedgerBounds {
  PerAxis<int> domain{};
  PerAxis<int> degree{};
  int grading = 0;
  std::int32_t level = 0;
  std::int64_t elements = 0;
  std::int64_t active_nodes = 0;

  friend bool operator==(const LedgerBounds&, const LedgerBounds&) = default;
};

/// What violates a claim. `content` is missing when the claim needs no mesh.
struct LedgerViolation {
  std::optional<Case> content;
  std::string says;  ///< the witness in words, or the reason
};

/// A case comes before another one if it has fewer marks (or boxes: steps come before boxes), then the smaller domain,
/// lower degrees, smaller m, the shorter text, and at last the lesser text. A total order.
bool is_smaller(const LedgerViolation& one, const LedgerViolation& other);

enum class LedgerResult {
  no_violation,  ///< the hypothesis was met, and nothing violates the claim
  violated,
  undecided,  ///< the hypothesis was never met: the run says nothing
};

/// "no-violation", "violated", "undecided".
const char* result_name(LedgerResult result);

/// What a run found out about one claim. A trial is one call of one of the claim's functions.
struct LedgerRecord {
  std::string claim;
  std::int64_t meshes = 0;     ///< distinct meshes that on_mesh was tried on
  std::int64_t sequences = 0;  ///< sequences that on_sequence was tried on
  std::int64_t alone = 0;      ///< 1 if `alone` was tried
  std::int64_t holds = 0;      ///< trials by outcome
  std::int64_t violated = 0;
  std::int64_t not_applicable = 0;
  std::int64_t undecided = 0;
  std::int64_t met = 0;         ///< the sum of Trial::met
  std::int64_t trials_met = 0;  ///< trials with met > 0
  /// Of the trials that were neither not applicable nor undecided: how many had each bias, each feature.
  std::map<std::string, std::int64_t> biases;
  std::map<std::string, std::int64_t> features;
  LedgerBounds bounds;  ///< of the same trials
  std::optional<LedgerViolation> smallest;

  std::int64_t trials() const { return meshes + sequences + alone; }
  LedgerResult result() const;
};

/// Puts two shares of one run together. REQUIRES: the same claim, disjoint sets of trials.
/// Laws (tests/properties/ledger_test.cpp): associative and commutative; an empty record changes nothing.
void merge(LedgerRecord& into, const LedgerRecord& other);

}  // namespace asts
