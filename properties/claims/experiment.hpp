#pragma once

#include "lib/exact/cube_root_field.hpp"
#include "lib/refine/self_similarity.hpp"
#include "properties/claims/claim.hpp"

namespace asts {

/// The experiment of Section 7: 5 x 5 x 5 unit cubes, m = 2, ..., 5, in each step one mark in the element of one and
/// the same corner. The paper does not state the degrees; they are taken to be (3,3,3), as in its other examples.

inline constexpr int kExperimentDivisor = 3000;

/// C for the experiment's degrees.
CubeRootNumber experiment_constant(int grading);

/// The certificate for that grading; InternalError if there is none within 40 steps.
SelfSimilarity experiment_certificate(int grading);

/// The limits of |G_n \ G_0|/n, for m = 2, ..., 5: what every late step adds.
std::int64_t experiment_limit(int grading);

/// Why the case is no run of the experiment; nothing if it is one.
std::optional<std::string> no_experiment(const Case& sequence);

/// The first n >= 1 with |G_n \ G_0| >= bound * n, for all n, by the certificate; nothing if there is none.
std::optional<Integer> first_step_not_below(const SelfSimilarity& certificate, const CubeRootNumber& bound);

/// `new_elements[n]` is |G_n \ G_0|: the ratio to n is below `bound` for n = 1, 2, ...
std::optional<ClaimWitness> judge_ratios(const std::vector<std::int64_t>& new_elements, const CubeRootNumber& bound,
                                         const char* bound_name);

/// For all n at once.
std::optional<ClaimWitness> judge_experiment(int grading, const SelfSimilarity& certificate,
                                             const CubeRootNumber& bound, const char* bound_name);

Trial experiment_on_sequence(const Case& sequence);
Trial experiment_alone(Extent extent);
Trial experiment_repaired_on_sequence(const Case& sequence);
Trial experiment_repaired_alone(Extent extent);

}  // namespace asts
