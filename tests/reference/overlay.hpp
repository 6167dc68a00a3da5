#pragma once

#include <array>

#include "tests/reference/refinement_claims.hpp"

/// The outlook's claims about the overlay, the coarsest common refinement of two meshes, from the definitions alone.
namespace asts::reference {

/// All intersections of an element of one mesh with one of the other that have interior; sorted.
Mesh common_refinement(const Mesh& one, const Mesh& other);

/// The mesh reflected along the axes that are set, sorted.
Mesh mirrored(const Setting& setting, const Mesh& mesh, const std::array<bool, dimension>& axes);

/// The overlay of two admissible meshes is admissible. Met: 1 if it is neither of the two.
ClaimTrial overlay_admissible(const Setting& setting, const Mesh& one, const Mesh& other);

/// elements(G1 (+) G2) + elements(G0) <= elements(G1) + elements(G2). Met: as above.
ClaimTrial overlay_cardinality(const Setting& setting, const Mesh& one, const Mesh& other);

}  // namespace asts::reference
