#pragma once

#include "properties/claims/claim.hpp"
#include "properties/claims/patch_relation.hpp"

namespace asts {

/// Algorithm 2.8 as a function of the mesh and the marks; the order of the result means nothing.
using ClosureOf = std::function<Elements(const RefinementTree& tree, const Elements& marks)>;

/// The program's own (lib/refine).
Elements closure_of_marks(const RefinementTree& tree, const Elements& marks);

/// `closure-least`: that a function is the least superset closed under "coarser in the patch", for every single mark
/// and the sets of mark_sets(), with the laws that follow. Counts the single marks whose closure has another element.
Trial judge_closure_least(const RefinementTree& tree, const ClosureOf& closure_of);

/// Definition 2.6 in place: replaces a leaf of the tree. A leaf that is none any more is left as it is.
using SubdivideOne = std::function<void(RefinementTree& tree, std::int32_t element)>;

/// `subdivision-commutes`: that subdividing the elements of a set one after the other gives the same mesh in different
/// orders. Counts the sets of two or more elements.
Trial judge_subdivision_commutes(const RefinementTree& tree, const SubdivideOne& subdivide);

Trial try_closure_least(MeshUnderTest& mesh);
Trial try_subdivision_commutes(MeshUnderTest& mesh);

}  // namespace asts
