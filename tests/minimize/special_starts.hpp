#pragma once

#include "lib/gen/draw.hpp"
#include "lib/mesh/case.hpp"

/// Starts of claims that random meshes do not violate.
namespace asts {

/// distance-bound: a row of cubes of which one is subdivided so finely, and its neighbour not at all, that for this m
/// the neighbour is too far from a mark; others are subdivided at random.
Case distance_start(Draw& draw);

/// lambda-sums: the finding's chain of marks in a row of cubes, longer than need be, in either direction, with marks
/// elsewhere.
Case chain_start(Draw& draw);

/// experiment-constant: marks at one corner, at any points of its element.
Case corner_start(Draw& draw);

}  // namespace asts
