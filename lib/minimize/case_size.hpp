#pragma once

#include <compare>
#include <cstdint>

#include "lib/mesh/case.hpp"

namespace asts {

/// How large a case is. Cases are compared by these figures, one after the other, and then by their numbers: a shortlex
/// order, in which every case has finitely many before it once its setting is bounded.
struct CaseSize {
  bool boxes = false;             ///< a case of steps comes before every case of boxes
  std::int64_t subdivisions = 0;  ///< elements that are subdivided in the last mesh; for boxes the number of boxes
  std::int64_t steps = 0;
  std::int64_t volume = 0;  ///< of the domain
  std::int64_t degree = 0;  ///< p1 + p2 + p3
  int grading = 2;          ///< m
  std::int64_t depth = 0;   ///< the highest level; for boxes the number of coordinates that are no integers

  friend auto operator<=>(const CaseSize&, const CaseSize&) = default;
};

/// The size of an explicit mesh.
CaseSize size_of_boxes(const Case& boxes);

/// Compares the numbers of two cases of one size: domain, degree, then steps and marks, or boxes, in their order, each
/// as a list of numbers.
std::strong_ordering compare_numbers(const Case& a, const Case& b);

}  // namespace asts
