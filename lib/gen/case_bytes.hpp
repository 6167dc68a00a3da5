#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lib/mesh/case.hpp"

namespace asts {

/// What cases made of bytes keep.
struct ByteCaseLimits {
  static constexpr int max_intervals = 32;    ///< of the boxes' grid along an axis
  static constexpr int max_denominator = 20;  ///< of coordinates

  int max_cubes = 216;     ///< unit cubes of the domain: 6 x 6 x 6, the least that p = (5,5,5) needs; at least 64
  int max_elements = 256;  ///< after every step
  int max_steps = 12;
  int max_cells = 250;  ///< of the grid in which explicit boxes are unions of cells; at least max_cubes
};

/// For the literal code under sanitizers. There is room for 4 x 5 x 5 cubes, in which everything that can be violated is;
/// p = (3,3,5) is the most that has an active node.
inline constexpr ByteCaseLimits kTinyCases{100, 116, 5, 110};

/// A case as bytes, for coverage-guided fuzzers, which cut strings of bytes, glue them and change single bytes. The
/// form, where `%` is the remainder and what is missing at the end is zero:
///
/// - byte 0: m = 2 + b % 3; explicit boxes when b / 3 % 4 == 3, else steps;
/// - bytes 1 to 3, one an axis: p = 5 when b % 4 == 3, else 3; the side by b / 4: p+1 (28 of 64), up to p+6, or, in 8
///   of 64, 1 to p. The axis with the most cubes beyond p gives way while the domain is larger than the limit;
/// - steps, until the bytes end: a byte for kind (b % 2) and number of marks, then 6 bytes a mark: for each axis the
///   unit cell (the value X~ is the domain's upper face), and the place within it, one of the 128 fractions with a
///   denominator up to 20. A step after which the mesh would be too large is left out;
/// - boxes: for each axis a count of planes and 2 bytes a plane (cell, fraction), each of which adds a plane to those
/// at
///   the integers, or takes it away. Then 2 bytes a box: its extents in cells of the grid between the planes. A box
///   begins in the first cell that no box covers yet and is cut off where others stand in its way, so that any bytes
///   give a tiling, and within the limits there is no tiling, pinwheels included, that none give.
///
/// Laws (tests/gen/case_bytes_test.cpp):
///  1. every string of bytes gives a case that parse_case can give, within the limits, whose boxes tile the domain;
///  2. case_of_bytes(bytes_of_case(c)) == c for every case that case_of_bytes gives, and for every case that
///     bytes_of_case gives bytes for, with the same limits; but boxes are put into the ascending order of their lower
///     corners.
/// Cost: that of replaying the steps.
Case case_of_bytes(std::span<const std::uint8_t> bytes, const ByteCaseLimits& limits = {});

/// Nothing for a case outside the limits, or with m > 4, p > 5, or coordinates that the form does not have.
/// REQUIRES: a case that parse_case can give.
std::optional<std::vector<std::uint8_t>> bytes_of_case(const Case& test_case, const ByteCaseLimits& limits = {});

}  // namespace asts
