#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// Marks the unmarked leaves that are coarser than one of the elements, which have this level, and meet its
/// environment; returns them in the order in which PatchSearch::coarser_in_patches finds them when its caller marks
/// each, whatever the number of threads.
///
/// How: the domain is cut into blocks, and each thread searches all patches for leaves in the blocks that it takes.
/// Which cluster finds a leaf first, and with which member, does not depend on other leaves; so merging the finds of
/// the blocks by cluster, member and block gives the one order. A thread writes to the nodes of its block only.
/// REQUIRES: as PatchSearch; jobs >= 1.
std::vector<std::int32_t> mark_coarser(RefinementTree& tree, std::span<const std::int32_t> elements, std::int32_t level,
                                       int jobs);

}  // namespace asts
