#pragma once

#include "properties/claims/claim.hpp"
#include "properties/claims/patch_relation.hpp"

namespace asts {

/// D(k) of Definition 2.4 for degree p and grading m.
using RadiusOf = std::function<ExactPoint(const PerAxis<int>& degree, int grading, int level)>;

/// D(k) in the three printed cases.
ExactPoint radius_as_printed(const PerAxis<int>& degree, int grading, int level);

/// `patch-shrinks-with-grading` for one p, m and level, against m - 1: D(k) does not grow, and shrinks along the axes
/// along which an element of level k has been subdivided; D(k) is the size of the element times p + 3/2. Counts the
/// axes along which it shrinks.
Trial judge_radius(const RadiusOf& radius, const PerAxis<int>& degree, int grading, int level);

/// The same for the levels of a mesh, and that D(k) is what the environments of its elements extend from their
/// midpoints where the domain does not cut them off.
Trial judge_radii_on_mesh(const RefinementTree& tree, const Elements& elements, const RadiusOf& radius);

/// The extent of U(K), by ranks.
using EnvironmentOf = std::function<RankInterval(const RefinementTree& tree, std::int32_t k, Axis axis)>;

/// `patches-nested`: for all pairs K within K^ among the elements of the tree and two generations below its leaves, the
/// patches in the mesh. Counts the pairs with K not K^.
Trial judge_patches_nested(const RefinementTree& tree, const EnvironmentOf& environment);

/// `levels-change-slowly`: no element in the patch of an element is two levels coarser. Counts the patches that have
/// elements of another level than their own.
Trial judge_levels_change_slowly(const RefinementTree& tree, const InPatch& in_patch);

Trial try_patch_shrinks(MeshUnderTest& mesh);
Trial try_patch_shrinks_alone(Extent extent);
Trial try_patches_nested(MeshUnderTest& mesh);
Trial try_levels_change_slowly(MeshUnderTest& mesh);

}  // namespace asts
