#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/spline/line_runs.hpp"

namespace asts {

/// A rectangle of a slice perturbation (Definition 5.1), closed and not empty, and two nodes to which it is owed.
///
/// R_x(q) is the part of the slice S_x(q) (x = q inside the active region) that lies both in the support of a node of
/// N_x(q) and in the support of an active node that is not in N_x(q); so it is the union, over all such pairs (v, w), of
/// S_x(q) with supp B_v and supp B_w. Given that q lies in both supports' x-range, v is in N_x(q) exactly if q is an
/// entry of xx(v), because xx(v) has all entries of X(v_2, v_3) in that range; and the same for w. So the pairs are
/// those whose x-vectors fail to overlap at q. Slices at other q are empty: N_x(q) is.
struct Perturbation {
  Box box;             ///< in half ranks; no extent along the axis
  std::int32_t in;     ///< a run whose nodes belong to N_axis(q)
  std::int32_t out;    ///< a run whose nodes do not
};

/// All rectangles of the perturbed region of an axis, without repetition of boxes, ascending; `runs` run along another
/// axis. The nodes' extents along the runs are those of all nodes of a run together, since they agree along the others.
/// Cost: linear in pairs of runs that fail to overlap along the axis, and sorting.
std::vector<Perturbation> perturbed_region(const TSplines& splines, const LineRuns& runs, Axis axis);

/// Where two perturbed regions of different axes meet: the least common point of the least pair of rectangles.
struct RegionsMeet {
  Axis first_axis;
  Axis second_axis;
  PerAxis<HalfRank> point;
  Perturbation first;
  Perturbation second;
};

/// The least common point (lexicographically) of two perturbed regions, if there is one. Closed sets: touching counts.
std::optional<RegionsMeet> find_common_point(const std::vector<Perturbation>& first, Axis first_axis,
                                             const std::vector<Perturbation>& second, Axis second_axis);

/// Definition 5.2. `along_x` are runs along axis 0, `along_y` along axis 1. Returns nothing when the mesh is
/// analysis-suitable, else the meeting of the first pair of axes, of (x,y), (x,z), (y,z), whose regions meet.
std::optional<RegionsMeet> find_meeting_regions(const TSplines& splines, const LineRuns& along_x,
                                                const LineRuns& along_y);

/// A node of a run whose support contains a coordinate along the run. REQUIRES: the run's support does.
std::int32_t node_covering(const TSplines& splines, const LineRuns& runs, std::int32_t run, HalfRank position);

}  // namespace asts
