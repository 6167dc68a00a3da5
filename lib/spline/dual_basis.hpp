#pragma once

#include <cstdint>
#include <optional>

#include "lib/spline/dual_compatibility.hpp"
#include "lib/spline/dual_functional.hpp"

namespace asts {

/// lambda_v(B_w) of Definition 6.2: the three factors and their product in one field that contains all of them.
struct DualValue {
  PerAxis<FieldElement> factors;
  FieldElement value;
};

DualValue dual_value(const Mesh& mesh, const TSplines& splines, std::int32_t v, std::int32_t w);

/// How often lambda_v(B_w) = delta_vw fails.
struct DualBasisFailures {
  /// Ordered pairs (v, w), v = w among them, whose supports meet in positive volume; counted when one fails, else 0.
  std::int64_t pairs = 0;
  std::int64_t failures = 0;    ///< of these
  std::optional<NodePair> one;  ///< a failing ordered pair, always the same for a mesh
};

/// Decides lambda_v(B_w) = delta_vw for all ordered pairs of active nodes. Where the supports do not meet in positive
/// volume, one factor vanishes because one pair of B-splines has no common interior of supports, and v is not w.
/// Otherwise, for v other than w, the product differs from 0 exactly if no factor does vanish; for v = w it is compared
/// with 1. Every factor is an exact number, evaluated once for a pair of index vectors; nothing is inferred from
/// overlap. For two bricks the indices along the axes are free, so failing pairs are counted axis by axis.
/// Cost: linear in the pairs of bricks, plus the pairs of index vectors of one axis that occur.
DualBasisFailures find_dual_failures(const Mesh& mesh, const TSplines& splines, const Bricks& bricks);

}  // namespace asts
