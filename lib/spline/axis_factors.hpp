#pragma once

#include <cstdint>
#include <vector>

#include "lib/mesh/pair_table.hpp"
#include "lib/spline/bricks.hpp"
#include "lib/spline/dual_functional.hpp"

namespace asts {

/// The index coordinates of an interned index vector of an axis.
std::vector<Rational> vector_coordinates(const Mesh& mesh, const TSplines& splines, Axis axis, std::int32_t vector);

/// Of the pairs of indices of two bricks along one axis, how many have a factor other than 0.
struct NonzeroCounts {
  std::int32_t forward = 0;   ///< lambda of the first brick's vectors on the B-splines of the second's
  std::int32_t backward = 0;  ///< the other way round
};

/// The factors lambda_X(N_X~) of Definition 6.2 along one axis of a mesh. Each ordered pair of index vectors is
/// evaluated once, each pair of profiles counted once. Vectors are identifiers of TSplines::vectors.
class AxisFactors {
 public:
  /// REQUIRES: the arguments outlive it.
  AxisFactors(const Mesh& mesh, const TSplines& splines, const Bricks& bricks, Axis axis);

  FieldElement lambda(std::int32_t x, std::int32_t x_tilde);
  bool is_zero(std::int32_t x, std::int32_t x_tilde);
  bool is_one(std::int32_t x);
  /// Whether the ranges of two index vectors have common interior; if not, the factor is 0.
  bool meet(std::int32_t x, std::int32_t x_tilde) const;

  NonzeroCounts nonzero(const Brick& one, const Brick& other);
  /// Pairs of index vectors of two bricks whose ranges have common interior.
  std::int64_t meeting(const Brick& one, const Brick& other) const;

 private:
  NonzeroCounts count(const AxisProfile& one, const AxisProfile& other);

  const Mesh& mesh_;
  const TSplines& splines_;
  const Bricks& bricks_;
  Axis axis_;
  DualFunctional functional_;
  PairTable<bool> zero_;
  PairTable<bool> one_;
  PairTable<NonzeroCounts> counts_;
};

}  // namespace asts
