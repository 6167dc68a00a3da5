#pragma once

#include "lib/exact/rational.hpp"
#include "lib/mesh/axis.hpp"

namespace asts {

/// What the paper gives as formulas in the level alone. Numbers are exact, in index coordinates.
/// Laws: (1) level_size is the size of every element of that level that Definition 2.6 makes from unit cubes;
/// (2) level_radius(p, m, k) is (p + 3/2) times level_size(m, k), axis by axis.

/// m^k, for k of either sign.
Rational grading_power(int grading, int exponent);

/// Appendix A.1, equation "df size": size(k), the sides of an element of level k, by its three cases. REQUIRES: k >= 0.
PerAxis<Rational> level_size(int grading, int level);

/// Definition 2.4: D(k), by its three cases. REQUIRES: k >= 0.
PerAxis<Rational> level_radius(const PerAxis<int>& degree, int grading, int level);

}  // namespace asts
