#pragma once

#include <cstdint>
#include <vector>

#include "lib/spline/index_sets.hpp"

namespace asts {

/// The elements that contain a point, closed: between one and 2^dimension of them, each once, in no particular order.
/// REQUIRES: the point lies in the domain. Cost: a search for each cell around the point.
std::vector<std::int32_t> elements_at(const Mesh& mesh, const PerAxis<HalfRank>& point);

/// Definition 4.2: is the point in the skeleton orthogonal to the axis, the union of the closed faces?
bool in_skeleton(const Mesh& mesh, Axis axis, const PerAxis<HalfRank>& point);

/// A node or an edge that hangs on an element, and an axis along which the element goes on at either side of it.
///
/// What hangs is used in Definition 5.1 ("all hanging nodes and edges (this is, all kinds of 3D T-junctions)") without
/// being defined. Here, as usual:
///   a node hangs on K if it lies in the closed element K and is no vertex of K;
///   an edge of an element hangs on K if it meets the relative interior of a face of K.
/// (A part of an edge of K is not called hanging: its ends are, as far as they are no vertices of K.) A node that lies
/// in the relative interior of a face hangs along two axes, one in that of an edge along one.
struct Hanging {
  Box box;               ///< a point, or a segment between two nodes, in ranks
  std::int32_t element;  ///< K
  Axis axis;             ///< along which the box has no extent and lies strictly between K's ends

  std::int32_t rank() const { return box.lower[at(axis)]; }  ///< of the slice that it lies in
  friend bool operator==(const Hanging&, const Hanging&) = default;
};

/// All of them: nodes first, each with every element that it hangs on and every such axis. Cost: a search for each node
/// and each piece of an edge.
std::vector<Hanging> hanging_nodes(const Mesh& mesh);
std::vector<Hanging> hanging_edges(const Mesh& mesh);

}  // namespace asts
