#include "lib/exact/grid_coordinate.hpp"

#include <limits>

#include "lib/exact/errors.hpp"

namespace asts {
namespace {

Integer power_of(int grading, int exponent) {
  Integer result;
  mpz_ui_pow_ui(result.backend().data(), static_cast<unsigned long>(grading), static_cast<unsigned long>(exponent));
  return result;
}

/// Multiplies `value` by grading^exponent; false, with `value` spoilt, when that leaves 64 bits.
bool scale_small(std::int64_t& value, int grading, int exponent) {
  if (value == 0) return true;
  for (; exponent > 0; --exponent) {
    if (__builtin_mul_overflow(value, std::int64_t{grading}, &value)) return false;
  }
  return true;
}

std::strong_ordering ordering(int comparison) { return comparison <=> 0; }

}  // namespace

GridCoordinate::GridCoordinate(int grading, std::int64_t index, int depth)
    : grading_(grading), depth_(depth), small_(index) {
  require(grading >= 2, "the grading of a grid is at least 2");
  require(depth >= 0, "the depth of a grid is not negative");
}

GridCoordinate::GridCoordinate(int grading, const Integer& index, int depth)
    : GridCoordinate(grading, std::int64_t{0}, depth) {
  static_assert(sizeof(long) == sizeof(std::int64_t), "GMP's signed long is the small integer");
  if (mpz_fits_slong_p(index.backend().data()) != 0) {
    small_ = mpz_get_si(index.backend().data());
  } else {
    wide_ = std::make_shared<const Integer>(index);
  }
}

GridCoordinate GridCoordinate::refined(int j) const {
  require(0 <= j && j <= grading_, "a refined point's number is between 0 and the grading");
  if (depth_ == std::numeric_limits<int>::max()) throw ResourceError("the depth of a grid exceeds 2^31 - 1");
  std::int64_t next = small_;
  if (is_small() && !__builtin_mul_overflow(next, std::int64_t{grading_}, &next) &&
      !__builtin_add_overflow(next, std::int64_t{j}, &next)) {
    return {grading_, next, depth_ + 1};
  }
  return {grading_, index() * grading_ + j, depth_ + 1};
}

GridCoordinate GridCoordinate::translated(std::int64_t steps) const {
  std::int64_t next = 0;
  if (is_small() && !__builtin_add_overflow(small_, steps, &next)) return {grading_, next, depth_};
  return {grading_, index() + steps, depth_};
}

GridCoordinate GridCoordinate::at_depth(int deeper) const {
  require(deeper >= depth_, "a coordinate moves to a deeper grid only");
  std::int64_t scaled = small_;
  if (is_small() && scale_small(scaled, grading_, deeper - depth_)) return {grading_, scaled, deeper};
  return {grading_, index() * power_of(grading_, deeper - depth_), deeper};
}

GridCoordinate GridCoordinate::canonical() const {
  if (is_small()) {
    if (small_ == 0) return {grading_, std::int64_t{0}, 0};
    std::int64_t reduced = small_;
    int depth = depth_;
    for (; depth > 0 && reduced % grading_ == 0; --depth) reduced /= grading_;
    return {grading_, reduced, depth};
  }
  Integer reduced = *wide_;
  int depth = depth_;
  const auto divisor = static_cast<unsigned long>(grading_);
  for (; depth > 0 && mpz_divisible_ui_p(reduced.backend().data(), divisor) != 0; --depth) reduced /= grading_;
  return {grading_, reduced, depth};
}

Rational GridCoordinate::to_rational() const {
  if (depth_ == 0) return index();  // most coordinates of coarse meshes; spares a greatest common divisor
  return {index(), power_of(grading_, depth_)};
}

std::strong_ordering operator<=>(const GridCoordinate& a, const GridCoordinate& b) {
  require(a.grading_ == b.grading_, "coordinates of different gradings lie on different grids");
  if (a.depth_ > b.depth_) return 0 <=> (b <=> a);
  if (a.depth_ < b.depth_) return a.at_depth(b.depth_) <=> b;
  if (a.is_small() && b.is_small()) return a.small_ <=> b.small_;
  return ordering(a.index().compare(b.index()));
}

}  // namespace asts

std::size_t std::hash<asts::GridCoordinate>::operator()(const asts::GridCoordinate& coordinate) const {
  const asts::GridCoordinate lowest = coordinate.canonical();
  const std::size_t index_hash =
      lowest.is_small() ? std::hash<std::int64_t>()(lowest.small_index()) : std::hash<asts::Integer>()(lowest.index());
  // Grids share small indices at many depths; an odd factor keeps (index, depth) pairs apart.
  return index_hash * 0x9E3779B97F4A7C15U + static_cast<std::size_t>(lowest.depth());
}
