#include <array>

#include "properties/claims/claim.hpp"
#include "properties/claims/family_equations.hpp"
#include "properties/claims/radius_bounds.hpp"

namespace asts {

namespace {

template <FamilyJudge judge>
Trial on_families(MeshUnderTest& mesh) {
  return judge_families(families_of(mesh), judge);
}

template <FamilyJudge judge>
Trial on_every_grading(Extent) {
  return judge_families(families_of_every_grading(), judge);
}

constexpr const char* kPairs = "pairs of an element and its parent";

constexpr std::array kClaims{
    Claim{.id = "size-formula",
          .source = "A.1, equation df size",
          .statement = "size(l(K)), by its three cases, is the size of every element K that successive subdivisions "
                       "of a unit cube make",
          .kind = ClaimKind::equation,
          .meshes = "r",
          .met_means = kPairs,
          .on_mesh = on_families<judge_size>,
          .alone = on_every_grading<judge_size>},
    Claim{.id = "child-distance",
          .source = "A.1, equations parent dist and child dist",
          .statement = "K in child(K^): Dist(K,K^) is m^-(l+6)/3 along x, m^-(l+5)/3 along y, m^-(l+4)/3 along z for "
                       "l = l(K^) = 0, 1, 2 mod 3 and 0 along the other axes; rewritten, it is m^-(l+5)/3 along x, "
                       "m^-(l+4)/3 along y, m^-(l+3)/3 along z for l = l(K) = 1, 2, 0 mod 3; for every child",
          .kind = ClaimKind::equation,
          .meshes = "r",
          .met_means = kPairs,
          .refuted = true,
          .on_mesh = on_families<judge_child_distance>,
          .alone = on_every_grading<judge_child_distance>},
    Claim{.id = "child-distance-repaired",
          .source = "A.1, equations parent dist and child dist",
          .statement = "for the j-th child K of K^: Dist(K,K^) is |2j-1-m|/(2m) times the side of K^ along the axis of "
                       "the split, and 0 along the other axes",
          .kind = ClaimKind::equation,
          .meshes = "r",
          .met_means = kPairs,
          .on_mesh = on_families<judge_child_distance_repaired>,
          .alone = on_every_grading<judge_child_distance_repaired>},
    Claim{.id = "patch-radius-step",
          .source = "A.1, behind equation child dist",
          .statement = "K in child(K^): D(l(K)) + Dist(K,K^) <= D(l(K)-1), with Dist of Definition 2.3",
          .kind = ClaimKind::equation,
          .meshes = "r",
          .met_means = kPairs,
          .on_mesh = on_families<judge_radius_step>,
          .alone = on_every_grading<judge_radius_step>},
    Claim{.id = "radius-bounds",
          .source = "A.3, equations D bounded, size bounded and magic radius",
          .statement = "D(k) <= m^-k/3 p~; size(k) is decreasing and <= m^-k/3 (1, m^1/3, m^2/3); K~ in G in A and K~' "
                       "in its patch have Dist(K~,K~') <= m^-l(K~)/3 (p~ + s)",
          .kind = ClaimKind::equation,
          .meshes = "a",
          .met_means = "pairs of an element and another one in its patch; alone: triples of m, p and k",
          .on_mesh = radius_bounds_on_mesh,
          .alone = radius_bounds_alone,
          .max_elements = 150,
          .stride = 2},
    Claim{.id = "child-distance-bound",
          .source = "A.3, end",
          .statement = "K in child(K_0), l = l(K): Dist(K_0,K) <= (m^-(l+5)/3, m^-(l+4)/3, m^-(l+3)/3)",
          .kind = ClaimKind::equation,
          .meshes = "r",
          .met_means = kPairs,
          .refuted = true,
          .on_mesh = on_families<judge_child_bound>,
          .alone = on_every_grading<judge_child_bound>},
    Claim{.id = "child-distance-bound-repaired",
          .source = "A.3, end",
          .statement = "K in child(K_0), l = l(K): Dist(K_0,K) <= (m-1)/2 (m^-(l+2)/3, m^-(l+1)/3, m^-l/3)",
          .kind = ClaimKind::equation,
          .meshes = "r",
          .met_means = kPairs,
          .on_mesh = on_families<judge_child_bound_repaired>,
          .alone = on_every_grading<judge_child_bound_repaired>},
};

}  // namespace

std::span<const Claim> equation_claims() { return kClaims; }

}  // namespace asts
