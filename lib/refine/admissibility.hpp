#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// A subdivided element and an element of the mesh that is coarser and meets its environment.
struct CoarserInPatch {
  std::int32_t element;
  std::int32_t coarser;
};

/// Definition 3.2 for a mesh whose history is unknown. Returns nothing when the mesh is admissible, else the reason why
/// not, with the lowest level of `element` there is.
///
/// Criterion: a mesh that level-directed subdivisions make is admissible exactly if for every element K of its tree
/// that is no leaf, every leaf K' that meets U(K) has level(K') >= level(K).
/// Proof. "Only if": K was subdivided in some mesh of the sequence, admissibly, so all elements that met U(K) then had
/// level(K) or more; the leaves that meet U(K) now are these elements or lie in them, and levels grow downwards.
/// "If": subdivide the inner elements of the tree in the order of their levels. When K's turn comes, K is there, since
/// the elements above it have had theirs. Suppose some K' of the mesh at hand meets U(K) and has level(K') < level(K).
/// Elements of the tree with such a level that are no leaves have been subdivided, so K' is a leaf of the tree, which
/// contradicts the criterion. So each subdivision is admissible (Definition 3.1). The proof needs no lemma on patches,
/// and shows in passing that every admissible mesh arises by level-increasing admissible subdivisions.
///
/// Cost: see PatchSearch; every inner element is asked once.
/// Levels are asked by so many threads; the result does not depend on them.
/// REQUIRES: no leaf is marked, ranks are up to date; jobs >= 1.
std::optional<CoarserInPatch> find_inadmissible(const RefinementTree& tree, int jobs = 1);

/// Definition 3.1 for one step of a history: whether there is an order in which subdividing these distinct leaves one
/// after the other is admissible each time.
///
/// If there is such an order, that of rising levels is one: subdividing an element never lowers a level in another's
/// patch, and what stands in the way of an element is coarser than it. In that order, when K's turn comes, an element
/// K' of K's patch with a lower level stands in the way unless it belongs to the set and its children are as fine as K:
/// then it has been subdivided, and its children that meet U(K) have level(K') + 1 >= level(K).
/// REQUIRES: as above.
bool is_admissible_subdivision(const RefinementTree& tree, std::span<const std::int32_t> leaves);

/// Whether the mesh is still admissible after elements of an admissible mesh were subdivided, admissibly or not: by the
/// criterion of find_inadmissible, asked of these elements alone. The others met it before, and leaves only get finer.
/// `subdivided` are nodes of the tree that are no leaves any more. Cost: that of a search for these (PatchSearch).
/// Levels are asked by so many threads; the result does not depend on them.
/// REQUIRES: as above; the mesh before was admissible; jobs >= 1.
bool stays_admissible(const RefinementTree& tree, std::span<const std::int32_t> subdivided, int jobs = 1);

}  // namespace asts
