#include "tests/reference/equation_checks.hpp"

namespace asts::reference {

namespace {

constexpr const char* too_far = "a child is farther from its parent than the bound";
constexpr const char* too_large = "a coordinate exceeds its bound";

constexpr ClaimKind kinds[] = {
    {"size-formula", "other-size", "the sides of K are not size(l(K))", check_size},
    {"child-distance", "other-distance", "Dist(K,K^) is not what the formula by the parent's level says",
     check_distance_by_parent},
    {"child-distance", "other-distance", "Dist(K,K^) is not what the formula by the child's level says",
     check_distance_by_child},
    {"child-distance-repaired", "other-distance", "Dist(K,K^) is not the repaired formula's", check_repaired_distance},
    {"patch-radius-step", "radius-step", "D(l(K)) + Dist(K,K^) exceeds D(l(K) - 1)", check_radius_step},
    {"child-distance-bound", "bound-exceeded", too_far, check_child_bound},
    {"child-distance-bound-repaired", "bound-exceeded", too_far, check_repaired_child_bound},
    {"radius-bounds", "radius-unbounded", too_large, check_radius_bound},
    {"radius-bounds", "size-unbounded", too_large, check_size_bound},
    {"radius-bounds", "size-grows", "size(k) exceeds size(k - 1)", check_size_grows},
    {"radius-bounds", "patch-distance", too_large, check_patch_distance},
};

}  // namespace

std::span<const ClaimKind> equation_kinds() { return kinds; }

}  // namespace asts::reference
