#pragma once

#include "properties/claims/claim.hpp"

namespace asts {

/// Definition 5.1, end: R_x, R_y and R_z are empty. Met: the slices inside the active region on which N_x(q), N_y(r) or
/// N_z(s) is not empty; on the others the slice perturbation is empty by definition.
Trial judge_unperturbed(MeshUnderTest& mesh);

/// All elements have one level. (By subdivisions that makes the mesh uniform: elements of one level are of one size,
/// and their sides are at multiples of it.)
Trial uniform_unperturbed(MeshUnderTest& mesh);

/// The uniform mesh of a level. REQUIRES: it is small enough for memory.
RefinementTree uniform_tree(const Setting& setting, int level);

/// Uniform meshes for p in {3,5,7}^3, m = 2..5 and levels from 0, in domains with an active region of a unit cube, of a
/// point, and of a box: as far as the mesh has few elements.
Trial uniform_unperturbed_alone(Extent extent);

}  // namespace asts
