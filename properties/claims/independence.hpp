#pragma once

#include "lib/spline/tsplines.hpp"
#include "properties/claims/claim.hpp"

namespace asts {

/// Claim dc-implies-independent (Corollary 6.8), without dual functionals.
///
/// Read as printed: the set {B_v | v in N_A} of functions on R^3, or on the closed domain, which contains all their
/// supports. A physical domain would be the image of the active region alone. Restrictions of functions may depend on
/// each other where the functions do not (tests/spline/independence_test.cpp has two such B-splines), and the proof
/// says nothing about them, because lambda_v looks at all of supp B_v. No generated mesh is known where it matters; the
/// test of this claim counts such meshes.

/// The conclusion alone, for any mesh: independent, or a combination that was verified to vanish on every element.
/// Throws BudgetExhausted for more nodes than an elimination should be tried for.
Verdict judge_independence(const Mesh& mesh, const TSplines& splines);

/// Pairs of bricks (groups of nodes that are part of one tensor product) whose supports have common interior and whose
/// index vectors fail to overlap along one axis: dual-compatible, but not part of a tensor-product basis.
std::int64_t pairs_partially_overlapping(const Bricks& bricks);

Trial try_independence(MeshUnderTest& mesh);

}  // namespace asts
