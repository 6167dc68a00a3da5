#pragma once

#include <vector>

#include "lib/spline/perfect_bspline.hpp"
#include "properties/claims/claim.hpp"

namespace asts {

/// Claim perfect-bspline (Proposition 6.1), for one perfect B-spline, in two parts.

/// The integral of B* over [-1, 1] is 1, and G rises from 0 to 1: B* is positive inside every piece, because none of
/// its Bernstein coefficients there is negative and one is positive.
Verdict judge_perfect_shape(const PerfectBspline& spline);

/// supp lambda_X = supp N_X for each index vector X. lambda_X(f) is the integral of f D^(p+1)(G_X phi_X) over
/// [x_1, x_(p+2)], so its support is [x_1, x_(p+2)] exactly if that density vanishes on no part of the interval; and it
/// is a polynomial between images of the y_j, so exactly if none of these polynomials is 0. N_X must be positive
/// somewhere in each piece. `met` counts the vectors that are not evenly spaced.
Trial judge_dual_support(const PerfectBspline& spline, const std::vector<std::vector<Rational>>& vectors);

/// Degrees 3, ..., 15 (long: 31), each with vectors that are even, crowded towards one end, both ends or the middle,
/// and pseudo-random.
Trial try_perfect_bspline(Extent extent);

/// The degrees and index vectors of one mesh.
Trial try_perfect_bspline_on(MeshUnderTest& mesh);

}  // namespace asts
