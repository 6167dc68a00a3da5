#include "tests/reference/theorem_5_3_kinds.hpp"

namespace asts::reference {

namespace {

constexpr const char* wrong_node =
    "the split says of the node the opposite of what it is after the step: in the nodes of the slice at xi or not";

constexpr ClaimKind kinds[] = {
    {"admissible-implies-as", "perturbed-regions-meet", nullptr, check_admissible_implies_as},
    {"new-nodes-keep-regions", "region-changed",
     "away from the new slices the perturbed region of the axis is not the same after the step: only one of them has "
     "the "
     "point",
     check_region_changed},
    {"sigma-unperturbed", "sigma-meets-region",
     "Sigma meets the perturbed region of the axis, after the step, in the point", check_sigma_meets_region},
    {"new-node-split", "wrong-slice-node", wrong_node, check_new_node_split},
    {"new-node-split-repaired", "wrong-slice-node", wrong_node, check_new_node_split_repaired},
    {"new-node-split-repaired", "larger-sigma",
     "the point is in the slice and in the support of an old node whose projection is in the new face and not in the "
     "old "
     "slice's nodes, and it is not in Sigma",
     check_larger_sigma},
    {"new-node-split-repaired", "outside-old-region-and-sigma",
     "the point is in the slice perturbation after the step, not in the one before it, and not in Sigma",
     check_outside_old_region},
    {"second-patch-sizes", "larger-in-second-patch",
     "an element of the second-order patch is larger than the element along the axis", check_second_patch},
    {"sigma-extent", "sigma-too-large", "a part of Sigma leaves the box that is said to contain Sigma",
     check_sigma_too_large},
    {"sigma-extent", "node-too-far",
     "the node's support meets Sigma, but the node is outside the box that is said to contain it", check_node_too_far},
};

}  // namespace

std::span<const ClaimKind> theorem_5_3_kinds() { return kinds; }

}  // namespace asts::reference
