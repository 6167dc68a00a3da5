#pragma once

#include "tests/reference/spline.hpp"

namespace asts::reference {

/// Definition 5.1: is v in N_x(q) (N_y, N_z by axis), that is, (q, v2, v3) in the closed skeleton?
/// q may be any real number, but only the finitely many coordinates of axis-orthogonal faces give a nonempty N_x(q),
/// and an empty N_x(q) gives an empty R_x(q).
template <class T>
bool in_slice_nodes(const Space<T>& space, std::size_t axis, const T& q, const PointIn<T>& v);

/// The coordinates of axis-orthogonal faces inside the closed active region, sorted: all q that matter.
template <class T>
std::vector<T> slices(const Space<T>& space, std::size_t axis);

/// The intersection of two closed boxes (points, edges and rectangles among them), nothing when they are disjoint.
/// Touching boxes intersect.
template <class T>
std::optional<BasicBox<T>> closed_intersection(const BasicBox<T>& first, const BasicBox<T>& second);

/// Definition 5.1: R_x(q) as a union of closed rectangles: the slice S_x(q) of the closed active region, cut with
/// supp B_v and supp B_w, for every v in N_x(q) and w in N_A \ N_x(q). Closed supports: touching counts. Each rectangle
/// once; those that lie in another one are kept.
template <class T>
std::vector<BasicBox<T>> slice_perturbation(const Space<T>& space, const std::vector<ActiveNode<T>>& splines,
                                            std::size_t axis, const T& q);

/// Definition 5.1: is t in R_x? That is, t in AR, and t lies in the closed supports of a node of N_x(t_x) and of an
/// active node outside N_x(t_x).
template <class T>
bool in_perturbed_region(const Space<T>& space, const std::vector<ActiveNode<T>>& splines, std::size_t axis,
                         const PointIn<T>& t);

/// Definition 5.2, literally, by rectangles: no rectangle of one perturbed region meets one of another.
template <class T>
bool analysis_suitable_by_rectangles(const Space<T>& space, const std::vector<ActiveNode<T>>& splines);

/// Definition 5.2, literally, by points: a common point of two perturbed regions, if any. When they meet, some closed
/// rectangles meet, in a closed box whose lower corner has only coordinates of supports, slices and the active region:
/// so it is enough to ask for all points made of such coordinates.
template <class T>
std::optional<PointIn<T>> perturbed_regions_meet(const Space<T>& space, const std::vector<ActiveNode<T>>& splines);

/// Condition (6.1): every entry of one vector within the CLOSED range of the other is an entry of the other.
template <class T>
bool overlap(const std::vector<T>& first, const std::vector<T>& second);

/// Definition 6.3: the index vectors overlap in at least two of the three dimensions.
template <class T>
bool partially_overlap(const ActiveNode<T>& v, const ActiveNode<T>& w);

/// Definition 6.4: the first pair of active nodes (by position) whose supports' intersection has positive volume and
/// that do not partially overlap; nothing when the mesh is dual-compatible.
template <class T>
std::optional<std::pair<std::size_t, std::size_t>> not_dual_compatible(const std::vector<ActiveNode<T>>& splines);

}  // namespace asts::reference
