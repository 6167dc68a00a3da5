#pragma once

#include "tests/reference/cube_root.hpp"
#include "tests/reference/refine.hpp"

/// The statements of Section 7, transcribed from the paper. `scale` multiplies the bounds, so that tests can compare
/// where these are not far away: 1 is the paper's.
namespace asts::reference {

/// Lemma 7.2: d_1, d_2, d_3; axis from 0.
RootSum distance_constant(const Setting& setting, int axis);

/// With (m-1)(m^(1/3)-1)/(2m) in place of (m^(1/3)-1)/m^2, as the repaired claims have it.
RootSum repaired_distance_constant(const Setting& setting, int axis);

/// Theorem 7.1: C, for these d_1, d_2, d_3.
using DistanceConstant = RootSum (*)(const Setting&, int axis);
RootSum complexity_constant(const Setting& setting, DistanceConstant d = distance_constant);

/// Lemma 7.2 for one mesh and one set of marks. REQUIRES: every element has a level.
bool distance_bound_holds(const Setting& setting, const Mesh& mesh, const std::vector<std::size_t>& marked,
                          const Rational& scale);

/// G_0, ..., G_J and M_0, ..., M_(J-1), as boxes.
struct Sequence {
  Setting setting;
  std::vector<Mesh> meshes;
  std::vector<Mesh> marks;
};

/// Theorem 7.1 for each j = 1, ..., J.
bool complexity_bound_holds(const Sequence& sequence, const Rational& scale);

/// (3) and (4) in the proof of Theorem 7.1, for G_J; `reach` multiplies the distance in the definition of lambda.
bool lambda_sums_hold(const Sequence& sequence, const Rational& reach, const Rational& scale);

}  // namespace asts::reference
