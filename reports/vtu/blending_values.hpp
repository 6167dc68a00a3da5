#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/mesh/mesh.hpp"
#include "lib/spline/tsplines.hpp"

namespace asts {

/// The number of the active node at a point; nothing when there is none. Cost: logarithmic in the nodes.
std::optional<std::int32_t> active_node_at(const Mesh& mesh, const TSplines& splines, const PerAxis<Rational>& point);

/// The blending function B_v of an active node (Definition 4.5), in exact arithmetic: the product of the B-splines of
/// its index vectors. REQUIRES: all index vectors exist.
class BlendingFunction {
 public:
  BlendingFunction(const Mesh& mesh, const TSplines& splines, std::int32_t node);

  /// N of one axis at a coordinate, 0 outside the vector's range. Cost: O(p^2) operations.
  Rational factor(Axis axis, const Rational& coordinate) const;

  /// The index vector of an axis.
  const std::vector<Rational>& knots(Axis axis) const { return knots_[at(axis)]; }

 private:
  PerAxis<std::vector<Rational>> knots_;
};

/// A blending function on a lattice over its support: each of the p+1 intervals of its index vector along each axis in
/// 4 equal parts; in 2 or 1 where there would be more than kMostSamples points.
struct BlendingSamples {
  static constexpr std::size_t kMostSamples = 1'000'000;

  PerAxis<std::vector<Rational>> coordinates;  ///< ascending
  PerAxis<std::vector<Rational>> factors;      ///< of each coordinate; a value of B_v is a product of three
};

BlendingSamples blending_samples(const BlendingFunction& function);

}  // namespace asts
