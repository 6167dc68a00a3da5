#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/spline/bricks.hpp"

namespace asts {

/// The perturbed region of an axis (Definition 5.1) as boxes of half ranks, without extent along the axis, disjoint as
/// sets of lattice points (see Rectangle), ascending slice by slice. On a refinement of the initial mesh, where lines
/// run along the active region's sides, equal regions are equal lists of boxes (see UnionIntersection).
///
/// R_x(q) is the part of the slice S_x(q) (x = q inside the active region) that lies both in the support of a node of
/// N_x(q) and in the support of an active node that is not in N_x(q). Slices at a q where no line runs are empty:
/// N_x(q) is. Given that q lies in the x-range of supp B_v, v is in N_x(q) exactly if q is an entry of xx(v), because
/// xx(v) has all entries of X(v_2, v_3) in that range. The nodes of a brick with q in the union of their x-ranges all
/// are in N_x(q) or all are not, as far as their supports meet the slice, according as q is an entry of the brick along
/// x; and since the other indices are free, their supports' part of the slice is that of the brick's support. So R_x(q)
/// is the intersection of two unions of rectangles: those of the bricks with the entry q, and those of the bricks that
/// reach q without having it; clipped to the active region. Cost: the sum over the bricks of the lines that they reach
/// along the axis, and painting each slice once.
///
/// `within` is what the slices are cut from: TSplines::region as Definition 5.1 prints it. With whole_domain() the
/// slices are those of the closed domain, which supports never leave; the regions are larger then, and have slices
/// outside the active region.
std::vector<Box> perturbed_region(const Bricks& bricks, Axis axis, const ActiveRegion& within);
/// As printed.
std::vector<Box> perturbed_region(const TSplines& splines, const Bricks& bricks, Axis axis);

/// The three of them.
using PerturbedRegions = PerAxis<std::vector<Box>>;
PerturbedRegions perturbed_regions(const Bricks& bricks, const ActiveRegion& within);

/// Where two perturbed regions of different axes meet: their least common point (lexicographically).
struct RegionsMeet {
  Axis first_axis;
  Axis second_axis;
  PerAxis<HalfRank> point;
};

/// Definition 5.2: nothing when no two of the regions meet, else the meeting of the first pair of axes, of (x,y),
/// (x,z), (y,z), whose regions meet. Closed sets: touching counts.
std::optional<RegionsMeet> find_meeting(const PerturbedRegions& regions);

/// Definition 5.2 for a mesh: nothing when it is analysis-suitable.
std::optional<RegionsMeet> find_meeting_regions(const TSplines& splines, const Bricks& bricks);

/// Two nodes that show that a point is in R_axis: both supports contain it, the first node is in N_axis(q) for the
/// point's coordinate q, the second is not. The least nodes of the first bricks there are. REQUIRES: it is.
std::pair<std::int32_t, std::int32_t> nodes_behind(const TSplines& splines, const Bricks& bricks, Axis axis,
                                                   const PerAxis<HalfRank>& point);

}  // namespace asts
