#pragma once

#include <cstdint>
#include <span>

#include "lib/gen/draw.hpp"
#include "lib/mesh/case.hpp"
#include "lib/mesh/setting.hpp"

namespace asts {

/// How large random cases get.
struct CaseLimits {
  int max_degree = 3;               ///< odd; each axis draws its own from 3, 5, ..., max_degree
  int max_grading = 5;              ///< from 2
  int max_side = 7;                 ///< unit cubes along an axis
  std::int64_t max_cubes = 150;     ///< unit cubes of the initial mesh, as far as degrees allow (see below)
  std::int64_t max_elements = 250;  ///< of every mesh of the case, unless the initial mesh leaves no room
  int max_steps = 6;                ///< refine or subdivide steps, or operations that make an explicit mesh
};

/// What a random case is made to provoke. Each generator draws one of its biases first.
enum class Bias {
  // admissible: steps of Algorithm 2.9
  marks_anywhere,   ///< marks at random points of the domain, on faces of elements too
  marks_clustered,  ///< several marks a step near one point that stays
  marks_corner,     ///< the element in one corner of the domain, again and again (Example 2.10)
  marks_deep,       ///< one element of the highest level there is, again and again
  // bare: subdivisions without closure (Definition 2.6)
  bare_scattered,     ///< random elements
  bare_stacked,       ///< descendants of one element, so that levels jump
  bare_one_left_out,  ///< an admissible mesh, then a closure in which one element is left out
  bare_touching,      ///< two elements so far apart that supports of their nodes touch, nearly touch or just overlap
  bare_in_frame,      ///< elements outside the active region, whose nodes are not active
  // boxes: explicit meshes
  boxes_cut,          ///< cuts across random parts of a tensor-product mesh at rationals that no subdivision makes
  boxes_merged,       ///< unit cubes merged to larger boxes
  boxes_frame,        ///< the same outside the active region only, where index vectors end
  boxes_pinwheel,     ///< five boxes that no cut through separates
  boxes_planar,       ///< cuts of a planar mesh, extruded along one axis
  boxes_written_out,  ///< a bare or admissible case's last mesh as boxes in random order
  // trouble: drawn by random_trouble_case only
  marks_edge,          ///< admissible: elements along one edge of the domain
  marks_face,          ///< admissible: elements along one face of the domain
  marks_uniform,       ///< admissible: all elements, again and again
  marks_graded,        ///< admissible: one element again and again on a domain so long that levels fall to 0 inside the
                       ///< active region: on others the perturbed regions of two axes are never both there
  bare_smaller_patch,  ///< closures with an environment that reaches one element less far
  bare_interface,      ///< a column of elements whose levels fall with the distance from one of them, with gaps, on an
                       ///< axis so long that supports of nodes above and below have exactly one plane in common
  bare_holes,          ///< every element subdivided but for few large holes
  region_point,        ///< the active region is a point; steps of all kinds
  region_segment,      ///< the active region is a segment
  region_plane,        ///< the active region is a rectangle
  boxes_planar_inside,  ///< boxes: cuts of a planar mesh of unit squares that end inside the active region or not at
                        ///< all
};

/// "marks-anywhere", ..., "boxes-planar-inside".
const char* bias_name(Bias bias);

/// All biases, in the order above: first those of the three generators below, then those of trouble.
std::span<const Bias> all_biases();
std::span<const Bias> plain_biases();
std::span<const Bias> trouble_biases();

struct RandomCase {
  Case content;
  Bias bias;
};

/// Random cases. The same state of `draw` and the same limits give the same case.
/// Laws (tests/gen/random_case_test.cpp): (1) the case is valid: parse_case reads write_case back equal, explicit boxes
/// tile the domain; (2) the limits are kept; (3) random_admissible_case has only refine steps, random_bare_case has a
/// subdivide step, random_box_case an explicit mesh; (4) every bias occurs.
/// Most domains have at least p+1 cubes along each axis, so that there are active nodes; one in sixteen has an axis
/// with fewer. `max_cubes` and `max_side` give way to p+1.
RandomCase random_admissible_case(Draw& draw, const CaseLimits& limits);
RandomCase random_bare_case(Draw& draw, const CaseLimits& limits);
RandomCase random_box_case(Draw& draw, const CaseLimits& limits);

/// A case with one of the trouble biases. Laws (1) and (2) hold for it, and every such bias occurs, but: a region_*
/// bias shortens axes to p+1, and bare_interface has up to p+2 cubes along two axes and up to 2p+3 along the third, as
/// far as `max_cubes` allows more than (p+1)^2 (2p+2) of them. The only steps of marks_* are `refine`, those of bare_*
/// `subdivide`; region_* has both.
RandomCase random_trouble_case(Draw& draw, const CaseLimits& limits);

/// The two halves of all the generators, for callers that choose the bias: first the setting, then a case in it.
/// Law (5): the case has the setting, and the bias.
Setting setting_for(Draw& draw, const CaseLimits& limits, Bias bias);
RandomCase random_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits, Bias bias);

}  // namespace asts
