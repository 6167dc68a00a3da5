#pragma once

#include <cstdint>
#include <vector>

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// Elements of a mesh, by their nodes in its refinement tree.
using Elements = std::vector<std::int32_t>;

/// The leaves in the order of the tree's hierarchy, which is the same for every history of a mesh.
Elements leaves_in_order(const RefinementTree& tree);

/// The sets of marked elements on which a claim about every M is tried besides the single ones: no element, all, those
/// of the highest level, those of the lowest, and random ones with an element of the highest level in each. The random
/// ones depend on the mesh alone: a mesh gives the same sets again, whatever its history. Elements are in the tree's
/// order.
std::vector<Elements> mark_sets(const RefinementTree& tree);

}  // namespace asts
