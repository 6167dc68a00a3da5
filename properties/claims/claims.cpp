#include <algorithm>
#include <array>

#include "lib/exact/errors.hpp"
#include "properties/claims/claim.hpp"

namespace asts {

namespace {

/// The ledger's order: the paper's.
constexpr std::array<std::string_view, 43> kOrder{
    "example-table",
    "closure-least",
    "subdivision-commutes",
    "patch-shrinks-with-grading",
    "refine-admissible",
    "refine-generates-class",
    "patches-nested",
    "levels-change-slowly",
    "level-order-replay",
    "frame-in-index-sets",
    "index-vectors-exist",
    "uniform-unperturbed",
    "perturbed-cover-hanging",
    "planar-equals-classical",
    "admissible-implies-as",
    "new-nodes-keep-regions",
    "sigma-unperturbed",
    "new-node-split",
    "second-patch-sizes",
    "sigma-extent",
    "figure-slices",
    "figure-proof-levels",
    "perfect-bspline",
    "overlap-duality",
    "perturbed-means-no-overlap",
    "as-implies-dc",
    "dc-implies-as",
    "case-table",
    "dc-implies-dual-basis",
    "as-implies-dual-basis",
    "dc-implies-independent",
    "dc-within-weak-dc",
    "distance-bound",
    "complexity-bound",
    "lambda-sums",
    "experiment-constant",
    "size-formula",
    "child-distance",
    "patch-radius-step",
    "radius-bounds",
    "child-distance-bound",
    "overlay-admissible",
    "overlay-cardinality",
};

constexpr std::string_view kRepaired = "-repaired";

/// The place of a claim or of the claim that it repairs.
std::size_t place_of(const Claim& claim) {
  std::string_view id = claim.id;
  if (id.ends_with(kRepaired)) id.remove_suffix(kRepaired.size());
  const auto found = std::find(kOrder.begin(), kOrder.end(), id);
  ensure(found != kOrder.end(), "every claim has its place in the ledger's order");
  return static_cast<std::size_t>(found - kOrder.begin());
}

std::vector<Claim> ordered_claims() {
  std::vector<Claim> claims;
  for (const auto family : {refinement_claims(), equation_claims(), complexity_claims(), skeleton_claims(),
                            theorem_5_3_claims(), suitability_claims(), functional_claims(), independence_claims()}) {
    claims.insert(claims.end(), family.begin(), family.end());
  }
  const auto before = [](const Claim& a, const Claim& b) {
    return std::pair(place_of(a), std::string_view(a.id)) < std::pair(place_of(b), std::string_view(b.id));
  };
  std::stable_sort(claims.begin(), claims.end(), before);
  return claims;
}

template <class Function, class... Arguments>
Trial attempt(Function decide, const char* subject, Arguments&&... arguments) {
  if (decide == nullptr) return {Verdict::not_applicable(std::string("not a statement about ") + subject)};
  try {
    return decide(std::forward<Arguments>(arguments)...);
  } catch (const BudgetExhausted& exhausted) {
    return {Verdict::undecided(exhausted.what())};
  }
}

}  // namespace

const char* kind_name(ClaimKind kind) {
  constexpr std::array kNames{"example",     "algorithm", "definition", "remark", "theorem",    "lemma",
                              "proposition", "corollary", "equation",   "figure", "experiment", "conjecture"};
  return kNames.at(static_cast<std::size_t>(kind));
}

const std::vector<Claim>& all_claims() {
  static const std::vector<Claim> claims = ordered_claims();
  return claims;
}

std::span<const std::string_view> ledger_ids() { return kOrder; }

const Claim* find_claim(std::string_view id) {
  for (const Claim& claim : all_claims()) {
    if (claim.id == id) return &claim;
  }
  return nullptr;
}

Trial try_on_mesh(const Claim& claim, MeshUnderTest& mesh) { return attempt(claim.on_mesh, "one mesh", mesh); }

Trial try_on_sequence(const Claim& claim, const Case& sequence) {
  if (sequence.explicit_mesh) return {Verdict::not_applicable("an explicit mesh has no steps")};
  return attempt(claim.on_sequence, "a sequence of steps", sequence);
}

Trial try_alone(const Claim& claim, Extent extent) { return attempt(claim.alone, "anything without a mesh", extent); }

}  // namespace asts
