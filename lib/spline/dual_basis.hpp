#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "lib/spline/dual_compatibility.hpp"
#include "lib/spline/dual_functional.hpp"
#include "lib/spline/line_runs.hpp"

namespace asts {

/// lambda_X(N_X~) for the interned index vectors of one axis of a mesh, each ordered pair of vectors evaluated once.
class VectorPairings {
 public:
  /// REQUIRES: `mesh` and `splines` outlive it.
  VectorPairings(const Mesh& mesh, const TSplines& splines, Axis axis);

  /// lambda of the vector `x` on the B-spline of the vector `x_tilde`.
  FieldElement lambda(std::int32_t x, std::int32_t x_tilde);
  bool is_zero(std::int32_t x, std::int32_t x_tilde) { return slot(x, x_tilde) == kZero; }
  bool is_one(std::int32_t x, std::int32_t x_tilde) { return slot(x, x_tilde) == kOne; }

 private:
  static constexpr std::int32_t kZero = 0;
  static constexpr std::int32_t kOne = 1;

  std::int32_t slot(std::int32_t x, std::int32_t x_tilde);
  std::int32_t evaluate(std::int32_t x, std::int32_t x_tilde);

  const Mesh& mesh_;
  const TSplines& splines_;
  Axis axis_;
  DualFunctional functional_;
  std::vector<FieldElement> values_;  ///< 0, 1, and the others as they come
  std::unordered_map<std::uint64_t, std::int32_t> slots_;
};

/// lambda_v(B_w) of Definition 6.2: the three factors and their product in one field that contains all of them.
struct DualValue {
  PerAxis<FieldElement> factors;
  FieldElement value;
};

DualValue dual_value(const Mesh& mesh, const TSplines& splines, std::int32_t v, std::int32_t w);

/// How often lambda_v(B_w) = delta_vw fails.
struct DualBasisFailures {
  std::int64_t pairs = 0;         ///< ordered pairs (v, w), v = w among them, whose supports meet in positive volume
  std::int64_t failures = 0;      ///< of these
  std::optional<NodePair> least;  ///< the least failing ordered pair
};

/// Decides lambda_v(B_w) = delta_vw for all ordered pairs of active nodes. Where the supports do not meet in positive
/// volume, one factor vanishes because one pair of B-splines has no common interior of supports, and v is not w.
/// Otherwise the product differs from 0 exactly if no factor is 0, which is asked across the runs first; on the diagonal
/// it is compared with 1. Every factor is an exact number; nothing is inferred from overlap.
/// Cost: linear in the pairs of runs, plus pairs of nodes of those runs whose factors across both differ from 0; each
/// pair of index vectors is evaluated once.
/// REQUIRES: runs of these splines, along any axis.
DualBasisFailures find_dual_failures(const Mesh& mesh, const TSplines& splines, const LineRuns& runs);

}  // namespace asts
