#include <array>

#include "properties/claims/independence.hpp"

namespace asts {

std::span<const Claim> independence_claims() {
  static constexpr std::array claims{
      Claim{.id = "dc-implies-independent",
            .source = "Corollary 6.8",
            .statement = "if G is dual-compatible, then the set {B_v | v in N_A} of functions on the index domain is "
                         "linearly independent",
            .kind = ClaimKind::corollary,
            .meshes = "are",
            .met_means = "pairs of groups of active nodes in a dual-compatible mesh whose supports have common "
                         "interior and whose index vectors fail to overlap along one axis",
            .on_mesh = try_independence},
  };
  return claims;
}

}  // namespace asts
