#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// The reflections of the domain along a set of axes, all but the identity: x -> X~ - x along each axis that is set.
/// The class of meshes is closed under them: the initial mesh and the children of an element are symmetric
/// (Definitions 2.1, 2.5). It has no other symmetries in general, since levels fix the order of the axes
/// (Definition 2.6), whatever the domain's sides are.
std::array<PerAxis<bool>, 7> reflections();

/// A mesh and its refinement tree seen in a mirror.
struct Reflection {
  RefinementTree tree;
  std::vector<std::int32_t> image;  ///< the mirrored element of each element, by id; kNone for blocks
};

/// Laws (each has a test that names it): (1) every element of the result is the mirror image of its original, of the
/// same level, leaf for leaf; (2) reflecting twice gives the original mesh.
/// Cost: that of growing the tree anew. No leaf of the result is marked; its ranks are up to date.
Reflection reflect(const RefinementTree& tree, const PerAxis<bool>& axes);

}  // namespace asts
