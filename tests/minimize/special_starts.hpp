#pragma once

#include "lib/gen/draw.hpp"
#include "lib/mesh/case.hpp"

/// Starts of claims that random meshes do not violate.
namespace asts {

/// planar-equals-classical: cuts of a planar mesh that subdivisions of whole columns of unit cubes make; not all of
/// them violate it.
Case planar_steps(Draw& draw);
/// The same as explicit boxes with arbitrary cuts, extruded along any axis; not all of them violate it.
Case planar_boxes(Draw& draw);

/// figure-proof-levels: the drawn levels on the slice that the figure shows, of any degrees, on any domain with room
/// for the squares, and at most one level off the slice.
Case figure_start(Draw& draw);

/// distance-bound: a row of cubes of which one is subdivided so finely, and its neighbour not at all, that for this m
/// the neighbour is too far from a mark; others are subdivided at random.
Case distance_start(Draw& draw);

/// lambda-sums: the finding's chain of marks in a row of cubes, longer than need be, in either direction, with marks
/// elsewhere.
Case chain_start(Draw& draw);

/// experiment-constant: marks at one corner, at any points of its element.
Case corner_start(Draw& draw);

}  // namespace asts
