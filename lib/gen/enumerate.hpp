#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "lib/mesh/case.hpp"
#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// What is enumerated: every distinct mesh that at most `max_subdivisions` subdivisions (Definition 2.6, one element
/// each) make from the initial mesh (Definition 2.1).
///
/// A mesh of this kind is the set of its subdivided elements: the boxes of its refinement tree that are no leaves. The
/// sets that occur are those that have with an element also the element it is a child of. Different orders of the same
/// subdivisions make one mesh, which is visited once.
///
/// The canonical order. Elements are ordered by level, then by the lower corner of their unit cube (x first, then y,
/// then z), then by the indices of the children that lead from the unit cube to them. A mesh is written as the list of
/// its subdivided elements in this order. Meshes are compared by the number of subdivisions, then as lists,
/// lexicographically.
struct Enumeration {
  Setting setting;
  int max_subdivisions = 0;
  /// Only meshes that at most so many admissible subdivisions (Definition 3.1) make, each of them admissible. That is
  /// the admissible meshes (Definition 3.2) among those with at most so many subdivided elements: the order of rising
  /// levels is an admissible one (lib/refine/admissibility.hpp), and the canonical order is of this kind.
  bool admissible = false;
  /// The eight reflections of the domain along the axes map meshes to meshes, and environments to environments. Visits
  /// only the first mesh in the canonical order of those that reflections make of one another, with their number.
  bool up_to_reflection = false;
};

/// A mesh as it is visited. The mesh before its last subdivision was the latest visit with one subdivision fewer.
struct EnumeratedMesh {
  /// Ranks are up to date. Stays until the next visit of a mesh with as many subdivisions; its nodes have the same
  /// numbers in the trees of the meshes that extend it.
  const RefinementTree& tree;
  std::span<const std::int32_t> subdivided;  ///< nodes of the tree in the canonical order; there during the visit
  std::int64_t reflections;                  ///< distinct meshes that it stands for; 1 unless up_to_reflection
};

/// Visits each mesh once. Among meshes with the same number of subdivisions the visits go in the canonical order; the
/// initial mesh comes first.
///
/// How: elements that could be subdivided stand in a queue, at first the unit cubes. A mesh is extended by an element
/// of the queue, all those before it are given up for good, and its children join the queue at the end. Given a set
/// of elements, the first of the queue that belongs to it is the only one that can be taken, so that there is one way
/// to each set, and it leads through the set's elements in the canonical order. Therefore an element that cannot be
/// subdivided admissibly when its turn comes never can: what stands in the way is coarser and comes no more. And with
/// the first k elements of a list being compared first, a mesh that is the first among its reflections is an extension
/// of such a mesh: others need not be extended.
///
/// Cost: memory linear in the elements of one mesh times max_subdivisions. Throws InputError when max_subdivisions is
/// negative, or so large that the elements could not be numbered by 63 bits (nobody sees the end of it).
void enumerate_meshes(const Enumeration& enumeration, const std::function<void(const EnumeratedMesh&)>& visit);

/// The mesh as a case: one `subdivide` step an element, in the canonical order, marked by its lower corner. In an
/// admissible enumeration each step is admissible.
Case case_of(const EnumeratedMesh& mesh);

}  // namespace asts
