#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/gen/draw.hpp"
#include "lib/mesh/case.hpp"

namespace asts {

/// A planar mesh of boxes on the active region of a planar domain, to be continued into the frame and extruded. The
/// unit squares are the start; each cut divides one box. Coordinates are integers: `parts` to the unit.
class PlanarTiling {
 public:
  struct Box {
    std::array<int, 2> lower;
    std::array<int, 2> upper;
  };

  PlanarTiling(std::array<int, 2> squares, int parts);

  const std::vector<Box>& boxes() const { return boxes_; }
  /// Divides a box by a line across an axis. REQUIRES: strictly between its ends.
  void cut(std::size_t box, std::size_t axis, int place);
  /// Divides all boxes that a line across an axis runs through strictly inside, between two ends on the other axis.
  void cut_line(std::size_t axis, int place, int begin, int end);

  /// The mesh as explicit boxes: moved into the active region of the smallest domain that has it, with a frame of unit
  /// squares through which all lines that end on the region's sides run on to the border, and p+1 unit layers along z.
  Case extruded(const PerAxis<int>& degree) const;

 private:
  std::array<int, 2> squares_;
  int parts_;
  std::vector<Box> boxes_;
};

/// The ways to divide a unit square along the lines through its middle: whole, two halves (2), three (4), four (1).
inline constexpr int kSquareCuts = 8;

/// The tiling with parts = 2 that divides the squares, x running fastest, in the ways of a list of 0..7.
PlanarTiling halved_squares(std::array<int, 2> squares, const std::vector<int>& ways);

/// Random cuts of random boxes at random thirds or quarters and so on; about as many cuts as squares.
PlanarTiling random_planar_tiling(Draw& draw, std::array<int, 2> squares);

}  // namespace asts
