#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "lib/exact/rational.hpp"

namespace asts {

/// A point of the m-adic grid of step m^-depth (Definition 2.7: subdividing an element m times divides its step by m):
/// the number index/m^depth, with grading m >= 2, depth >= 0 and an index of any size.
///
/// The index lives in 64 bits while it fits and in a shared GMP integer beyond; every operation is checked and moves to
/// the wider form, so nothing wraps and depth has no ceiling.
///
/// Laws (each has a test that names it):
///  1. value: to_rational() == index/m^depth.
///  2. refinement: refined(j) is the value plus j m^-(depth+1), one deeper; refined(0) == *this and
///     refined(m) == translated(1).
///  3. translation: translated(a) is the value plus a m^-depth, and translated(a).translated(b) == translated(a + b).
///  4. order: <, == are the order of the values, whatever the depths.
///  5. canonical form: canonical() is equal to *this and has the lowest depth of all forms of the value.
///  6. hash: equal coordinates have equal hashes.
///  7. border: all of this holds on both sides of 2^63, and is_small() tells the sides apart.
class GridCoordinate {
 public:
  /// Throws InputError unless grading >= 2 and depth >= 0.
  GridCoordinate(int grading, std::int64_t index, int depth);
  GridCoordinate(int grading, const Integer& index, int depth);

  int grading() const { return grading_; }
  int depth() const { return depth_; }
  Integer index() const { return is_small() ? Integer(small_) : *wide_; }
  bool is_small() const { return wide_ == nullptr; }
  /// REQUIRES: is_small().
  std::int64_t small_index() const { return small_; }

  /// The point index*m + j at depth + 1. Throws InputError unless 0 <= j <= m.
  GridCoordinate refined(int j) const;

  /// The point `steps` grid steps of this depth away. Throws no overflow: promotes.
  GridCoordinate translated(std::int64_t steps) const;

  /// The same value on the grid of a depth that is at least this one; InputError otherwise.
  /// Cost: one multiplication a level in 64 bits, one power and one multiplication beyond.
  GridCoordinate at_depth(int deeper) const;

  /// The same value at the lowest depth: the depth is 0 or m does not divide the index.
  GridCoordinate canonical() const;

  Rational to_rational() const;

  /// Orders values. Throws InputError when the gradings differ. Cost: as at_depth of the shallower one.
  friend std::strong_ordering operator<=>(const GridCoordinate& a, const GridCoordinate& b);
  friend bool operator==(const GridCoordinate& a, const GridCoordinate& b) { return (a <=> b) == 0; }

 private:
  int grading_;
  int depth_;
  std::int64_t small_ = 0;               ///< the index where wide_ is null
  std::shared_ptr<const Integer> wide_;  ///< set exactly when the index does not fit into 64 bits
};

}  // namespace asts

template <>
struct std::hash<asts::GridCoordinate> {
  std::size_t operator()(const asts::GridCoordinate& coordinate) const;
};
