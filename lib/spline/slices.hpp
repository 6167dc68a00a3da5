#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lib/spline/rectangles.hpp"
#include "lib/spline/tsplines.hpp"

namespace asts {

/// The parts of Definition 5.1 for one slice S_x(q), node by node; perturbed_region is the fast form of the whole.

/// N_x(q) = {v in N_A : (q, v_2, v_3) in Xi_x}, for each active node whether it belongs to it. q may be on a line or
/// between lines (then the set is empty). By Definition 4.3 the condition is that q is in X(v_2, v_3).
/// Cost: a walk along each line of nodes.
std::vector<bool> slice_nodes(const Mesh& mesh, const TSplines& splines, Axis axis, HalfRank q);

/// S_x(q) cut with the supports of nodes: closed rectangles of half ranks of the other two axes, clipped to the active
/// region; nodes whose supports do not reach the slice add none. Empty when q is outside the active region.
std::vector<Rectangle> supports_in_slice(const TSplines& splines, Axis axis, HalfRank q,
                                         std::span<const std::int32_t> nodes);

/// A rectangle of the slice as a box of half ranks, without extent along the axis.
Box box_in_slice(Axis axis, HalfRank q, const Rectangle& rectangle);

/// Such a box without its own axis.
Rectangle rectangle_of(Axis axis, const Box& box);

}  // namespace asts
