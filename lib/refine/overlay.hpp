#pragma once

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// The outlook's overlay of two refinements of one initial mesh: their coarsest common refinement, G1 (+) G2. Its tree
/// has the elements that either tree has, so its mesh is
///
///     { K in G1 | K lies in an element of G2 }  union  { K in G2 | K lies in an element of G1 }.
///
/// Why it is the coarsest one: two elements of the class are nested or have no common interior, so each element of a
/// common refinement lies in an element of G1 and in one of G2, and the smaller of these two is in the set above. That
/// set is also the set of all intersections of an element of G1 with one of G2 that have interior.
///
/// Laws (each has a test that names it): (1) commutative, associative, idempotent, and the initial mesh is neutral, as
/// sets of elements; (2) a refinement of both, and every common refinement refines it; (3) G1 (+) G2 = G2 exactly if
/// G2 refines G1; (4) it commutes with the reflections of the domain.
/// Cost: linear in the nodes of both trees.
/// REQUIRES: one setting (InputError otherwise); no leaf is marked.
RefinementTree overlay(const RefinementTree& one, const RefinementTree& other);

}  // namespace asts
