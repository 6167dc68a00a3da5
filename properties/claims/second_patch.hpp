#pragma once

#include <cstdint>
#include <vector>

#include "properties/claims/admissible_steps.hpp"

namespace asts {

/// The elements of a mesh as the second-order patch needs them: extents, environments U(K) and sizes.
struct PatchElements {
  struct Element {
    std::int32_t leaf;
    Box extent;                 ///< ranks of the tree's lines; closed
    Box environment;            ///< likewise; open
    PerAxis<std::size_t> size;  ///< the place of the size among all sizes along the axis, ascending
  };

  std::vector<Element> elements;
};

PatchElements patch_elements(const RefinementTree& tree);

/// No element of the second-order patch, the patches of all elements of the patch of K, is larger than K along x or y:
/// role 0 and 1, the axis of K's subdivision and the next one. Elements that are larger along no axis are not looked
/// at. Met: the elements of the second-order patch that are larger than K along z, role 2.
Judgement judge_second_patch(const RefinementTree& tree, const PatchElements& all, std::size_t element);

/// The claim on one mesh G: for every K in G whose subdivision is admissible, given that G is admissible.
Trial judge_second_patches(MeshUnderTest& mesh);

}  // namespace asts
