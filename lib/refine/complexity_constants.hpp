#pragma once

#include "lib/exact/cube_root_field.hpp"
#include "lib/mesh/axis.hpp"

namespace asts {

/// Lemma 7.2: d_1, d_2, d_3, as printed.
PerAxis<CubeRootNumber> distance_constants(const PerAxis<int>& degree, int grading);

/// The same with the true distance of a child to its parent, at most (m-1)/2 (m^-(l+2)/3, m^-(l+1)/3, m^-l/3), in the
/// last line of the proof (Appendix A.3): the term (m^(1/3)-1)/m^2 becomes (m-1)(m^(1/3)-1)/(2m). Equal for m = 2.
PerAxis<CubeRootNumber> corrected_distance_constants(const PerAxis<int>& degree, int grading);

/// Theorem 7.1: C for given d_1, d_2, d_3.
CubeRootNumber complexity_constant(const PerAxis<CubeRootNumber>& d);

}  // namespace asts
