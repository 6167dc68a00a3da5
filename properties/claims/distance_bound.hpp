#pragma once

#include "lib/exact/cube_root_field.hpp"
#include "properties/claims/claim.hpp"
#include "properties/claims/leaf_patches.hpp"

namespace asts {

/// Lemma 7.2 for every M at once. The closure of M is the union of the closures of its elements, so a K in
/// refine(G, M) \ G is in refine(G, {K'}) \ G for some K' in M; and M = {K'} is a case of its own. So the lemma for all
/// M on a mesh says: for every K' in G and K in refine(G, {K'}) \ G, level(K) <= level(K') + 1 and Dist(K,K') <=
/// m^(-l(K)/3) d. Of the children K of one element the first and the last are the farthest ones from anything, axis by
/// axis.
///
/// `met` grows by the pairs of a mark K' and an element of its closure other than K'.
std::optional<ClaimWitness> judge_distance_bound(const RefinementTree& tree, const LeafPatches& patches,
                                                 const PerAxis<CubeRootNumber>& d, std::int64_t& met);

/// Up to here the printed constants do, for every odd p >= 3, though the proof uses a wrong distance of a child to its
/// parent.
///
/// Proof. Where K is no farther from K_0 along an axis than printed, the printed proof holds along that axis. It is
/// farther along the axis of the split alone: take x, so that l = l(K) is 1 mod 3, and count in sides of K_0 along x; y
/// and z are the same, as D and size go round with the level. K' = K_J, ..., K_0 have the levels l-1+J, ..., l-1. The
/// sides of K_(j-1) along x lie on the grid of K_j's side s_j, and K_(j-1) meets the open U(K_j), which reaches
/// (p+1) s_j beyond K_j: the gap between the two is at most p s_j. Adding gaps and sides,
///     Dist_x(K,K') <= 1 - 1/(2m) + (p+1)(s_1 + ... + s_J) - s_J/2 < F = 1 - 1/(2m) + 3(p+1)/(m-1),
/// as s_1, s_2, ... is 1/m three times, 1/m^2 three times, ... And m^(-l/3) d_1 is, with t = m^(1/3), in the same
/// units,
///     R = (p + (3+t)/2 + (t-1)/m^2)/(t-1).
/// R - F grows with p. For p = 3 and m = 2, ..., 1267 it is positive: computed exactly, one m after the other, in
/// tests/properties/complexity_claims_test.cpp. For p = 3 and m = 1268 it is negative, and a mesh is refined there that
/// violates the bound.
inline constexpr int kLargestGradingOfPrintedConstants = 1267;

Trial distance_bound_on_mesh(MeshUnderTest& mesh);
Trial distance_bound_repaired_on_mesh(MeshUnderTest& mesh);

}  // namespace asts
