#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "properties/claims/claim.hpp"
#include "properties/claims/subdivision_step.hpp"

namespace asts {

/// What a statement about one step comes to: a witness if it fails, and how often it was met.
struct Judgement {
  std::optional<ClaimWitness> violation;
  std::int64_t met = 0;
};

/// The leaves whose subdivision is admissible (Definition 3.1), ascending.
std::vector<std::int32_t> admissible_leaves(const RefinementTree& tree);

/// A statement of the proof of Theorem 5.3 on one mesh G: judged for every K in G whose subdivision is admissible,
/// given that G is admissible and analysis-suitable (the induction's hypothesis). Steps that reach no active node are
/// left out: nothing changes then (see reaches_active_nodes). The first violation is told; counting goes on.
Trial judge_steps(MeshUnderTest& before, const std::function<Judgement(const SubdivisionStep&)>& judge);

/// The same for a statement about elements alone; analysis-suitability is not asked for, and no such K is left out.
Trial judge_leaves(MeshUnderTest& before, const std::function<Judgement(std::int32_t leaf)>& judge);

}  // namespace asts
