#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lib/exact/cosine_field.hpp"
#include "lib/gen/draw.hpp"
#include "properties/claims/claim.hpp"

namespace asts {

/// Claim overlap-duality (Proposition 6.1): lambda_X(N_X~) = delta_(X X~) for vectors that overlap (Eq. 6.1).

struct VectorPair {
  std::vector<Rational> x;
  std::vector<Rational> x_tilde;
};

/// (X, X~) -> lambda_X(N_X~).
using Lambda = std::function<FieldElement(std::span<const Rational>, std::span<const Rational>)>;

/// Pairs that do not overlap are passed over. `met` counts pairs of different vectors that overlap and whose ranges
/// have more than a point in common: for the others one of the two factors of the integrand vanishes, or delta is 1.
Trial judge_duality(const std::vector<VectorPair>& pairs, const Lambda& lambda);

/// Pairs of strictly increasing rational vectors of p+2 entries: all windows of one uneven sequence with each other
/// (the same, shifted, touching and disjoint ones), the same pairs with one entry moved, and vectors drawn from the
/// points of a small grid. No mesh of the class makes most of them.
std::vector<VectorPair> random_vector_pairs(Draw& draw, int degree);

/// Odd degrees 3, ..., 9 (long: 15).
Trial try_overlap_duality(Extent extent);

/// All pairs of index vectors of each axis of one mesh. Throws BudgetExhausted above the mesh's budget of pairs.
Trial try_overlap_duality_on(MeshUnderTest& mesh);

}  // namespace asts
