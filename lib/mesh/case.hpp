#pragma once

#include <cstddef>
#include <vector>

#include "lib/exact/compact_rational.hpp"
#include "lib/mesh/axis.hpp"

namespace asts {

/// A point of the index domain, in index coordinates.
using Point = PerAxis<CompactRational>;

/// One step of a case: a call of Algorithm 2.9 (`refine`) or bare subdivisions (Definition 2.7, `subdivide`).
/// Each mark names the leaf element that contains the point; elements are half-open, but the domain's upper faces
/// belong to the last element.
struct Step {
  enum class Kind { refine, subdivide };
  Kind kind = Kind::refine;
  std::vector<Point> marks;

  friend bool operator==(const Step&, const Step&) = default;
};

/// One `element` line: a closed box, and the line it stands on (1-based; 0 when it does not come from a file).
struct ElementLine {
  Point lower;
  Point upper;
  std::size_t line = 0;

  /// The line is where the box was read, not what it is.
  friend bool operator==(const ElementLine& a, const ElementLine& b) {
    return a.lower == b.lower && a.upper == b.upper;
  }
};

/// A test case, the one type that generators, files, replay and reports share: the setting, and either steps that
/// refine the initial mesh or the mesh itself as boxes (then `explicit_mesh` is true and `steps` is empty).
struct Case {
  PerAxis<int> degree{3, 3, 3};  ///< p: odd, at least 3
  int grading = 2;               ///< m: at least 2
  PerAxis<int> domain{1, 1, 1};  ///< X~, Y~, Z~: at least 1
  std::vector<Step> steps;
  bool explicit_mesh = false;
  std::vector<ElementLine> elements;

  friend bool operator==(const Case&, const Case&) = default;
};

/// The bounds that a case must keep so that everything that follows fits into memory and 32-bit identifiers.
inline constexpr int kMaxDegree = 1'000'001;
inline constexpr int kMaxGrading = 1'000'000;
inline constexpr std::int64_t kMaxInitialElements = 100'000'000;

}  // namespace asts
