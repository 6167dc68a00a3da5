#pragma once

#include "lib/exact/cube_root_field.hpp"
#include "properties/claims/claim.hpp"
#include "properties/claims/leaf_patches.hpp"

namespace asts {

/// The bounds of Appendix A.3 on D(k), size(k) and on distances in a patch.

/// (D bounded), (size bounded) and "size is decreasing" for one level k: size(k) <= size(k - 1) where k >= 1.
std::optional<ClaimWitness> judge_level_bounds(const Setting& setting, int level);

/// (magic radius) without its factor m^(-l/3): p~ + s.
PerAxis<CubeRootNumber> patch_distance_factor(const Setting& setting);

/// For two elements of a mesh, the second in the patch of the first, of level l: Dist <= m^(-l/3) factor.
std::optional<ClaimWitness> judge_patch_distances(const RefinementTree& tree, const LeafPatches& patches,
                                                  const PerAxis<CubeRootNumber>& factor, std::int64_t& met);

Trial radius_bounds_on_mesh(MeshUnderTest& mesh);
Trial radius_bounds_alone(Extent extent);

}  // namespace asts
