#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/mesh.hpp"
#include "reports/vtu/vtu_file.hpp"

namespace asts {

/// A coordinate or value for drawing: rounded towards zero.
double drawn(const Rational& value);

/// Adds points and cells to a grid.
class GridBuilder {
 public:
  explicit GridBuilder(VtuGrid& grid) : grid_(grid) {}

  std::size_t points() const { return grid_.points.size() / kDimension; }
  std::size_t cells() const { return grid_.types.size(); }

  /// Returns the point's number. Throws ResourceError beyond VTK's 32-bit numbers.
  std::int32_t add_point(const PerAxis<double>& coordinates);
  /// `points`: numbers of points; throws as add_point.
  void add_cell(std::uint8_t type, std::span<const std::int32_t> points);

  /// The voxels of a lattice whose points, x slowest, begin at a number; returns how many.
  std::int64_t add_lattice(std::int32_t first_point, const PerAxis<std::size_t>& points);

 private:
  VtuGrid& grid_;
};

}  // namespace asts
