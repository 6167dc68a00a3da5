#include <array>

#include "properties/claims/claim.hpp"
#include "properties/claims/complexity_bounds.hpp"
#include "properties/claims/distance_bound.hpp"
#include "properties/claims/experiment.hpp"
#include "properties/claims/lambda_sums.hpp"

namespace asts {

namespace {

constexpr const char* kFarMarks = "pairs of a mark K' and an element other than K' that is subdivided for it";
constexpr const char* kClosureSteps = "steps in which more than the marks is subdivided; alone: certified m";

constexpr const char* kReachedPairs = "pairs of a new element K and a mark K~ of level >= 1 with lambda(K,K~) > 0";

constexpr std::array kClaims{
    Claim{.id = "distance-bound",
          .source = "Lemma 7.2",
          .statement = "M in G in A, K in refine(G,M) \\ G: some K' in M has l(K) <= l(K') + 1 and Dist(K,K') <= "
                       "m^-l(K)/3 (d_1,d_2,d_3), with the printed constants; for every m >= 2 and odd p >= 3",
          .kind = ClaimKind::lemma,
          .meshes = "a",
          .met_means = kFarMarks,
          .refuted = true,
          .on_mesh = distance_bound_on_mesh,
          .max_elements = 200},
    Claim{.id = "distance-bound-repaired",
          .source = "Lemma 7.2",
          .statement = "the same with (m-1)(m^1/3-1)/(2m) in place of (m^1/3-1)/m^2 in each of d_1, d_2, d_3; with the "
                       "printed constants for m <= 1267",
          .kind = ClaimKind::lemma,
          .meshes = "a",
          .met_means = kFarMarks,
          .on_mesh = distance_bound_repaired_on_mesh,
          .max_elements = 200},
    Claim{.id = "complexity-bound",
          .source = "Theorem 7.1",
          .statement = "G_j = refine(G_(j-1), M_(j-1)) for j = 1..J: |G_J \\ G_0| <= C sum |M_j|, for every J",
          .kind = ClaimKind::theorem,
          .meshes = "a",
          .met_means = "steps in which more than the marks is subdivided",
          .on_sequence = complexity_bound_on_sequence,
          .max_elements = 1000},
    Claim{.id = "lambda-sums",
          .source = "proof of Theorem 7.1, (3) and (4)",
          .statement =
              "each K in G_J \\ G_0: the sum of lambda(K,K~) over the marks K~ is >= 1; each mark K~: the sum of "
              "lambda(K,K~) over K in G_J \\ G_0 is <= C",
          .kind = ClaimKind::equation,
          .meshes = "a",
          .met_means = kReachedPairs,
          .refuted = true,
          .on_sequence = lambda_sums_on_sequence,
          .stride = 2},
    Claim{.id = "lambda-sums-repaired",
          .source = "proof of Theorem 7.1, (3) and (4)",
          .statement =
              "the same with the d_1, d_2, d_3 of distance-bound-repaired in lambda and in C; with the printed "
              "constants for m <= 1267",
          .kind = ClaimKind::equation,
          .meshes = "a",
          .met_means = kReachedPairs,
          .on_sequence = lambda_sums_repaired_on_sequence,
          .stride = 2},
    Claim{.id = "experiment-constant",
          .source = "Section 7, experiment",
          .statement = "5 x 5 x 5 cubes, p = (3,3,3), the same corner's element marked again and again, m = 2..5: new "
                       "elements / marks < C/3000, whatever the number of steps",
          .kind = ClaimKind::experiment,
          .meshes = "a",
          .met_means = kClosureSteps,
          .refuted = true,
          .on_sequence = experiment_on_sequence,
          .alone = experiment_alone},
    Claim{.id = "experiment-constant-repaired",
          .source = "Section 7, experiment",
          .statement =
              "the same: new elements / marks is below its limit, 3840, 1680, 1152, 924 for m = 2, 3, 4, 5, whatever "
              "the number of steps, and hence below C/2849",
          .kind = ClaimKind::experiment,
          .meshes = "a",
          .met_means = kClosureSteps,
          .on_sequence = experiment_repaired_on_sequence,
          .alone = experiment_repaired_alone},
};

}  // namespace

std::span<const Claim> complexity_claims() { return kClaims; }

}  // namespace asts
