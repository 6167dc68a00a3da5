#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// Algorithm 2.8 with a fault: the environment of an element reaches p+1/2 of its lengths from its midpoint instead of
/// p+3/2, one element less. Returns the marks and the elements that join them, marks first; nothing is marked in the
/// tree. Subdividing it misses admissibility narrowly, where the true closure is larger.
///
/// Half an element less would change nothing: an element coarser than K ends, along each axis, at integer multiples of
/// K's length there, as K does. The open environment ends p+1 lengths from K's sides, so whatever meets it reaches at
/// least a whole length into it.
///
/// Law (tests/gen/random_trouble_case_test.cpp): it is the least superset of the marks with: K in it, K' meeting the
/// smaller environment of K and level(K') < level(K) imply K' in it; so it is a subset of the closure.
/// Cost: linear in the leaves for each element of the result.
/// REQUIRES: distinct leaves; ranks are up to date.
std::vector<std::int32_t> smaller_closure(const RefinementTree& tree, std::span<const std::int32_t> marks);

}  // namespace asts
