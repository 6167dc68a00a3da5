#include <array>

#include "properties/claims/overlap_duality.hpp"
#include "properties/claims/perfect_bspline.hpp"

namespace asts {

std::span<const Claim> functional_claims() {
  static constexpr std::array claims{
      Claim{.id = "perfect-bspline",
            .source = "Proposition 6.1, proof",
            .statement = "the integral of B*_{p+1} over [-1,1] is 1; G_X rises from 0 at x_1 to 1 at x_{p+2} (B* > 0 "
                         "between neighbouring y_j); supp lambda_X = supp N_X = [x_1, x_{p+2}]",
            .kind = ClaimKind::proposition,
            .meshes = "",
            .met_means = "index vectors X with uneven steps whose density D^{p+1}(G_X phi_X) was looked at",
            .on_mesh = try_perfect_bspline_on,
            .alone = try_perfect_bspline},
      Claim{.id = "overlap-duality",
            .source = "Proposition 6.1",
            .statement = "if X and X~ overlap in the sense of (6.1), then lambda_X(N_{X~}) is 1 for X = X~ and 0 "
                         "otherwise",
            .kind = ClaimKind::proposition,
            .meshes = "",
            .met_means = "ordered pairs of different overlapping vectors whose ranges have an interval in common",
            .on_mesh = try_overlap_duality_on,
            .alone = try_overlap_duality},
  };
  return claims;
}

}  // namespace asts
