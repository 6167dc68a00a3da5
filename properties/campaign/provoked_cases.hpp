#pragma once

#include <array>

#include "lib/gen/draw.hpp"
#include "lib/mesh/case.hpp"

/// Random cases of kinds that the general generators make never or hardly ever, and that some claims are about. Each
/// is valid, and depends on the state of `draw` and the arguments alone.
namespace asts {

/// Columns of elements whose supports touch: random meshes of other kinds are hardly ever dual-compatible without being
/// analysis-suitable. No side is longer than 9.
Case interface_case(Draw& draw);
/// The same in the settings in which that happens most often: along one axis 2p+2 cubes, which is where supports touch,
/// along the others p+2, with the column in the middle; mostly p = 3 and m = 2.
Case small_interface_case(Draw& draw);

/// Cuts of a planar mesh of unit squares that end inside the active region or not at all, by subdivisions of whole
/// columns of unit cubes.
Case planar_case_of_steps(Draw& draw);
/// The same as explicit boxes with arbitrary cuts, extruded along any axis.
Case planar_case_of_boxes(Draw& draw);
/// The same with two or three squares along each axis, mostly p = 3: where one T-junction in so many faces another.
Case small_planar_case_of_boxes(Draw& draw);

/// The drawn levels on the slice that the figures in the proof of Theorem 5.3 show, of any degrees, on any domain with
/// room for the squares, and at most one level off the slice.
Case figure_case(Draw& draw);

/// Marks at one corner of 5 x 5 x 5 cubes with p = (3,3,3), at any points of its element; the number of steps is drawn
/// between two bounds.
Case corner_case(Draw& draw, int m, const std::array<int, 2>& steps_between);

/// Long and graded along one axis, so that an admissible mesh of few elements has perturbed regions of two axes.
Case graded_case(Draw& draw);

/// Marks anywhere on a domain with an axis that is shorter than the integers of its frame: at most (p-3)/2 cubes.
Case narrow_case(Draw& draw);

/// A row of cubes along x, for large m: one cube subdivided finely at its end, so that its patch reaches the next cube.
Case row_case(Draw& draw, int m);

// What rows are made of.

/// An empty case. Along the row the degree is 3: with a larger one the claims about large m hold for longer.
Case random_row(Draw& draw, int m, int most_length, int least_length, int breadth);
/// A place of the row, seen from one of its ends.
Point row_point(const Case& row, bool mirrored, const Rational& x);
void refine_at(Case& row, const Point& point);
/// `depth` steps at one place of a cube, 4 depth slabs of width 1/m from its end: a closure leads from level to level,
/// up to four slabs onwards each time. The last mark, of level depth, has one of level depth - 1 and so on in its
/// closure, at last the cube's neighbour. REQUIRES: 4 depth <= m.
void mark_towards_neighbour(Case& row, bool mirrored, int cube, int depth);

}  // namespace asts
