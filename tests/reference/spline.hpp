#pragma once

#include "tests/reference/grid.hpp"

namespace asts::reference {

template <class T>
using PointIn = std::array<T, dimension>;

/// A mesh with its active region, in units where T is exact: T = Rational (unit 1) or T = Grid (unit 1/scale).
/// Everything in Sections 4 to 6 that is decided here only compares coordinates.
template <class T>
struct Space {
  std::array<int, dimension> degree;
  BasicBox<T> active;  ///< the active region AR, CLOSED; empty when lower > upper on some axis
  std::vector<BasicBox<T>> elements;
};

template <class T>
Space<T> make_space(const Setting& setting, const Mesh& mesh, Grid scale);

/// Is the point in the closed box?
template <class T>
bool in_closed(const BasicBox<T>& box, const PointIn<T>& point);

/// Definition 4.1: N, the vertices of all elements, sorted, each once.
template <class T>
std::vector<PointIn<T>> nodes(const Space<T>& space);

/// Definition 4.1: N_A, the nodes in the closed active region, sorted.
template <class T>
std::vector<PointIn<T>> active_nodes(const Space<T>& space);

/// Definition 4.2: is the point in the `axis`-orthogonal skeleton, the union of all elements' closed faces?
template <class T>
bool in_skeleton(const Space<T>& space, std::size_t axis, const PointIn<T>& point);

/// Definition 4.3: X(y,z) (or Y(x,z), Z(x,y)): the coordinates that put `point`, moved along `axis`, into the closed
/// skeleton. point[axis] is ignored; the others may be any numbers. Sorted, each once.
template <class T>
std::vector<T> global_index_set(const Space<T>& space, std::size_t axis, const PointIn<T>& point);

/// Definition 4.4: the p+2 consecutive entries of the global index set with v's coordinate in the middle; nothing when
/// that coordinate is not in the set or has fewer than (p+1)/2 entries on a side.
template <class T>
std::optional<std::vector<T>> local_index_vector(const Space<T>& space, std::size_t axis, const PointIn<T>& v);

/// An active node v with its index vectors, supp B_v (CLOSED) and its three global index sets.
template <class T>
struct ActiveNode {
  PointIn<T> node;
  std::array<std::vector<T>, dimension> vectors;
  BasicBox<T> support;
  std::array<std::vector<T>, dimension> index_sets;
};

/// The node with its three index vectors; nothing when one of them does not exist.
template <class T>
std::optional<ActiveNode<T>> active_node(const Space<T>& space, const PointIn<T>& v);

/// All active nodes with their splines; nothing when one of them lacks an index vector.
template <class T>
std::optional<std::vector<ActiveNode<T>>> active_splines(const Space<T>& space);

/// |first cap second| > 0.
template <class T>
bool intersect_with_volume(const BasicBox<T>& first, const BasicBox<T>& second);

}  // namespace asts::reference
