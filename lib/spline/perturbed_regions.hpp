#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/spline/bricks.hpp"

namespace asts {

/// A rectangle of a slice perturbation (Definition 5.1), closed and not empty, and the bricks to which it is owed.
///
/// R_x(q) is the part of the slice S_x(q) (x = q inside the active region) that lies both in the support of a node of
/// N_x(q) and in the support of an active node that is not in N_x(q); so it is the union, over all such pairs (v, w), of
/// S_x(q) with supp B_v and supp B_w. Given that q lies in both supports' x-range, v is in N_x(q) exactly if q is an
/// entry of xx(v), because xx(v) has all entries of X(v_2, v_3) in that range; and the same for w. So the pairs are
/// those whose x-vectors fail to overlap at q. Slices at other q are empty: N_x(q) is.
///
/// For two bricks and an axis, the q are the entries of one in the closed range of the other that the other lacks
/// (AxisOverlap). Since the other indices are free, the rectangle is that of the bricks' supports across the axis.
struct Perturbation {
  Box box;           ///< in half ranks; no extent along the axis
  std::int32_t in;   ///< a brick with nodes that belong to N_axis(q)
  std::int32_t out;  ///< a brick whose nodes do not, as far as their supports meet the slice
};

/// Rectangles whose union is the perturbed region of an axis, without repetition, ascending.
/// Cost: linear in pairs of bricks, and sorting those that fail to overlap along the axis.
std::vector<Perturbation> perturbed_region(const TSplines& splines, const Bricks& bricks, Axis axis);

/// Where two perturbed regions of different axes meet: their least common point (lexicographically) and the least pair
/// of rectangles that have it.
struct RegionsMeet {
  Axis first_axis;
  Axis second_axis;
  PerAxis<HalfRank> point;
  Perturbation first;
  Perturbation second;
};

/// Closed sets: touching counts.
std::optional<RegionsMeet> find_common_point(const std::vector<Perturbation>& first, Axis first_axis,
                                             const std::vector<Perturbation>& second, Axis second_axis);

/// Definition 5.2: nothing when the mesh is analysis-suitable, else the meeting of the first pair of axes, of (x,y),
/// (x,z), (y,z), whose regions meet.
std::optional<RegionsMeet> find_meeting_regions(const TSplines& splines, const Bricks& bricks);

/// A pair of nodes to which a rectangle owes a point: the first is in N_axis(q), the second is not.
std::pair<std::int32_t, std::int32_t> nodes_behind(const TSplines& splines, const Bricks& bricks,
                                                   const Perturbation& piece, Axis axis,
                                                   const PerAxis<HalfRank>& point);

}  // namespace asts
