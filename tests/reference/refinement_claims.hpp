#pragma once

#include "tests/reference/mesh.hpp"

/// The claims of Sections 2 and 3, from the definitions alone: each for one mesh, with the count of its
/// non-trivial cases.
namespace asts::reference {

struct ClaimTrial {
  bool holds = true;
  std::size_t met = 0;
  bool operator==(const ClaimTrial&) const = default;
};

/// The levels of the elements of a mesh, their patches, and the coarser elements in these, as sorted positions.
struct Patches {
  std::vector<int> levels;
  std::vector<std::vector<std::size_t>> of;
  std::vector<std::vector<std::size_t>> coarser;
};
Patches patches(const Setting& setting, const Mesh& mesh);

/// Is the set (sorted positions) a superset of the marks, closed under "coarser in the patch", and does every closed
/// superset of the marks contain it? The last is asked for each element K of the set that is no mark: among the closed
/// sets without K there is a greatest one, since unions of closed sets are closed, and it must lack a mark.
bool is_least_closed_superset(const Patches& patches, const std::vector<std::size_t>& marks,
                              const std::vector<std::size_t>& set);

/// Does every superset of the marks that is closed under "coarser in the patch" contain the element? As above.
bool in_every_closed_superset(const Patches& patches, const std::vector<std::size_t>& marks, std::size_t element);

/// Algorithm 2.8 gives the least closed superset of every single mark. Met: closures of more than the mark.
ClaimTrial closure_least(const Setting& setting, const Mesh& mesh);

/// Theorem 3.3 for every single mark. Met: as above. REQUIRES: the mesh is admissible.
ClaimTrial refine_admissible(const Setting& setting, const Mesh& mesh);

/// The elements that were subdivided on the way to the mesh: by rising level, and by lower corners among equal ones.
Mesh inner_by_level(const Setting& setting, const Mesh& mesh);

/// Every inner element of the mesh's tree, marked alone in the order of levels, is subdivided alone by refine, and the
/// last mesh is the given one. Met: marks of level >= 1. REQUIRES: every box is in the class.
ClaimTrial refine_generates(const Setting& setting, const Mesh& mesh);

/// The same with single subdivisions that Definition 3.1 allows.
ClaimTrial level_order(const Setting& setting, const Mesh& mesh);

/// Lemma 3.4 for all pairs of different nested elements among the tree's and two generations below the mesh's own.
/// Met: the pairs.
ClaimTrial patches_nested(const Setting& setting, const Mesh& mesh);

/// Lemma 3.5. Met: elements with an element of another level in their patch.
ClaimTrial levels_change_slowly(const Setting& setting, const Mesh& mesh);

}  // namespace asts::reference
