#pragma once

#include "tests/reference/grid.hpp"

namespace asts::reference {

/// One element of the refinement tree: a box that level-directed subdivisions (Definition 2.6) of a unit cube make.
struct TreeElement {
  Box box;
  int level = 0;
  Box environment;                      ///< open, U(K)
  std::optional<std::size_t> position;  ///< position in the mesh when it is an element of it
  std::vector<std::size_t> children;    ///< positions in the tree; empty when it is an element of the mesh
};

/// The elements of the mesh that are in the class (made from unit cubes by Definition 2.6) together with all their
/// ancestors, and the positions of the mesh's boxes that are not in the class.
struct RefinementTree {
  std::vector<TreeElement> elements;
  std::vector<std::size_t> outside;
};

/// Builds the tree of a mesh of unknown history. REQUIRES: the boxes tile the domain.
RefinementTree refinement_tree(const Setting& setting, const Mesh& mesh);

/// Is the box made from a unit cube of the domain by level-directed subdivisions?
bool in_class(const Setting& setting, const Box& box);

/// Definition 3.2. A box outside the class: not admissible. Otherwise starts from the initial mesh and performs any
/// admissible subdivision of an element that the mesh has subdivided, until none is left; admissible iff that ends at
/// the mesh.
///
/// Why one greedy run is enough: a sequence that makes the mesh subdivides exactly the inner elements of the tree,
/// each once. Let the run be stuck, and let K be the first element in such a sequence that the run has not
/// subdivided. All elements before K in the sequence are subdivided in the run's mesh, and K is an element of it
/// because its parent comes before K. So the run's mesh is a refinement of the mesh on which K's subdivision was
/// admissible. An element K'' of the run's mesh that meets U(K) lies in an element K' of that mesh, which then meets
/// U(K) too, and l(K'') >= l(K') >= l(K): subdividing others never lowers a level in a patch. So K can be subdivided
/// in the run: it was not stuck. Definition 3.2's steps with several elements are concatenations of single ones.
bool admissible_mesh(const Setting& setting, const Mesh& mesh, const RefinementTree& tree);

/// Definition 3.2 by trying every order of single admissible subdivisions. REQUIRES: at most 20 inner elements.
bool admissible_mesh_exhaustive(const Setting& setting, const RefinementTree& tree);

/// A counterexample to Lemma 3.4's conclusion: K inside L, and an element C in the patch of K, not in that of L.
struct NotNested {
  std::size_t inner, outer;  ///< positions in the tree
  std::size_t element;       ///< position in the mesh
};

/// Lemma 3.4's conclusion for every pair of nested elements of the tree, patches compared as sets of elements.
std::optional<NotNested> patches_not_nested(const Setting& setting, const Mesh& mesh, const RefinementTree& tree);

}  // namespace asts::reference
