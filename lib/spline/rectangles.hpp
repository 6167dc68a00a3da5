#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace asts {

/// A closed rectangle on the lattice of half ranks of two axes: even numbers are lines, odd ones the open intervals
/// between neighbouring lines. A closed set that is a union of points, edges and cells of the lines is the set of its
/// lattice points, and intersections and unions are those of lattice points.
struct Rectangle {
  std::array<std::int32_t, 2> lower;
  std::array<std::int32_t, 2> upper;

  friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

inline bool meet(const Rectangle& one, const Rectangle& other) {
  return one.lower[0] <= other.upper[0] && other.lower[0] <= one.upper[0] && one.lower[1] <= other.upper[1] &&
         other.lower[1] <= one.upper[1];
}

/// The intersection of two unions of closed rectangles, as disjoint rectangles of lattice points, ascending by their
/// lower corners. Where all ends of the given rectangles are even, the result depends on the set of points alone: it
/// has a rectangle for each maximal run of points of a row and each maximal series of neighbouring rows with that run.
///
/// Both unions are painted as bits on the grid of the rectangles' own ends (lines and the intervals between them), rows
/// along the first axis; the common bits are gathered into rectangles.
/// Cost: O(n log n) and, for each rectangle, its rows times its columns/64; memory rows times columns/64.
class UnionIntersection {
 public:
  std::vector<Rectangle> of(const std::vector<Rectangle>& one, const std::vector<Rectangle>& other);

 private:
  using Words = std::vector<std::uint64_t>;

  void choose_grid(const std::vector<Rectangle>& one, const std::vector<Rectangle>& other);
  void paint(const std::vector<Rectangle>& rectangles, Words& words) const;
  std::vector<Rectangle> gather() const;
  /// The lattice points of a range of grid places of an axis; lower > upper if there is none.
  std::array<std::int32_t, 2> lattice_range(std::size_t axis, std::size_t first, std::size_t last) const;
  std::size_t place(std::size_t axis, std::int32_t end) const;

  std::array<std::vector<std::int32_t>, 2> ends_;  ///< ends_[i] is at place 2i, the interval behind it at place 2i+1
  std::size_t words_a_row_ = 0;
  Words one_;
  Words other_;
};

}  // namespace asts
