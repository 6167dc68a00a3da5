#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// Algorithm 2.8: the closure of marked leaves, the least superset M~ with: K in M~ and K' in the patch of K with
/// level(K') < level(K) imply K' in M~. The least superset does not depend on the order of the loop, so the levels are
/// worked off from the finest to the coarsest, each once.
/// The result is ordered by falling level; within a level the marks come first, then what a search through the patches
/// finds, in its order (PatchSearch), which does not depend on `jobs`, the number of threads. All of it is marked in
/// the tree.
/// Cost: that of PatchSearch for the closure, level by level: linear in the closure and the nodes above it as long as
/// the patches of a cluster of 64 elements have a bounded number of elements that are too coarse.
/// REQUIRES: leaves of the tree, up-to-date ranks; repetitions are allowed; jobs >= 1.
std::vector<std::int32_t> mark_closure(RefinementTree& tree, std::span<const std::int32_t> marks, int jobs = 1);

/// Definition 2.7: subdivides distinct leaves, marked or not, and brings the ranks up to date. Since distinct leaves
/// are disjoint elements of one mesh, the order makes no difference to the mesh.
void subdivide_all(RefinementTree& tree, std::span<const std::int32_t> leaves, int jobs = 1);

/// Algorithm 2.9: subdivides the closure of the marks. Returns the subdivided elements, as mark_closure does.
std::vector<std::int32_t> refine(RefinementTree& tree, std::span<const std::int32_t> marks);

}  // namespace asts
