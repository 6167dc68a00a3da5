#include "properties/claims/hanging_cover.hpp"

#include <algorithm>

#include "lib/spline/hanging.hpp"
#include "lib/spline/perturbed_regions.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

bool contains(const Box& box, const PerAxis<HalfRank>& point) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (point[axis] < box.lower[axis] || box.upper[axis] < point[axis]) return false;
  }
  return true;
}

bool covered(const PerturbedRegions& regions, const PerAxis<HalfRank>& point) {
  return std::any_of(regions.begin(), regions.end(), [&](const std::vector<Box>& region) {
    return std::any_of(region.begin(), region.end(), [&](const Box& box) { return contains(box, point); });
  });
}

/// The points and pieces between lines that a node or an edge consists of, as half ranks.
std::vector<PerAxis<HalfRank>> lattice_points(const Box& box) {
  PerAxis<HalfRank> point;
  std::size_t along = 0;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    point[axis] = 2 * box.lower[axis];
    if (box.lower[axis] < box.upper[axis]) along = axis;
  }
  std::vector<PerAxis<HalfRank>> result;
  for (; point[along] <= 2 * box.upper[along]; ++point[along]) result.push_back(point);
  return result;
}

bool in_region(const ActiveRegion& region, const PerAxis<HalfRank>& point) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    if (region.empty || !region.contains(axis, point[at(axis)])) return false;
  }
  return true;
}

constexpr const char* kInNoRegion =
    "the node or edge hangs on the element along the axis and has a point in no perturbed region";
constexpr const char* kNotInOwnRegion =
    "the node or edge hangs on the element along the axis and has a point of the active region outside the perturbed "
    "region of that axis";

Verdict not_covered(const Mesh& mesh, const Hanging& hanging, const PerAxis<HalfRank>& point, const char* says) {
  ExactBox box;
  ExactPoint outside;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::size_t a = at(axis);
    box.lower[a] = mesh.coordinate(axis, hanging.box.lower[a]);
    box.upper[a] = mesh.coordinate(axis, hanging.box.upper[a]);
    outside[a] = (mesh.coordinate(axis, point[a] / 2) + mesh.coordinate(axis, (point[a] + 1) / 2)) / 2;
  }
  const bool node = hanging.box.lower == hanging.box.upper;
  return Verdict::violated(ClaimWitness{node ? "hanging-node-not-covered" : "hanging-edge-not-covered",
                                        says,
                                        {{"axis", std::string(axis_name(hanging.axis))},
                                         {"hanging", box},
                                         {"element", describe_element(mesh, hanging.element)},
                                         {"point", outside},
                                         {"slice", mesh.coordinate(hanging.axis, hanging.rank())}}});
}

std::vector<Hanging> all_hanging(const Mesh& mesh) {
  std::vector<Hanging> result = hanging_nodes(mesh);
  const std::vector<Hanging> edges = hanging_edges(mesh);
  result.insert(result.end(), edges.begin(), edges.end());
  return result;
}

/// A corner of a box, by bits.
PerAxis<HalfRank> corner_of(const Box& box, std::size_t bits) {
  PerAxis<HalfRank> corner;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    corner[axis] = 2 * ((bits >> axis & 1) != 0 ? box.upper[axis] : box.lower[axis]);
  }
  return corner;
}

template <class Predicate>
bool any_corner(const Box& box, const Predicate& predicate) {
  for (std::size_t bits = 0; bits < (std::size_t{1} << kDimension); ++bits) {
    if (predicate(corner_of(box, bits))) return true;
  }
  return false;
}

/// An active vertex of the element that is not in N_x(q) for the slice that the node or edge lies in.
bool has_vertex_outside(const Mesh& mesh, const ActiveRegion& region, const Hanging& hanging) {
  return any_corner(mesh.elements[at(hanging.element)], [&](const PerAxis<HalfRank>& vertex) {
    PerAxis<HalfRank> projection = vertex;
    projection[at(hanging.axis)] = 2 * hanging.rank();
    return in_region(region, vertex) && !in_skeleton(mesh, hanging.axis, projection);
  });
}

}  // namespace

PerturbedRegions perturbed_regions(MeshUnderTest& mesh) {
  PerturbedRegions regions;
  if (mesh.splines().nodes.empty()) return regions;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    regions[at(axis)] = perturbed_region(mesh.splines(), mesh.bricks(), axis);
  }
  return regions;
}

Trial judge_hanging_cover(const Mesh& mesh, const PerturbedRegions& regions) {
  Trial trial;
  const std::vector<Hanging> all = all_hanging(mesh);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && all[i].box == all[i - 1].box) continue;
    ++trial.met;
    for (const PerAxis<HalfRank>& point : lattice_points(all[i].box)) {
      if (covered(regions, point)) continue;
      trial.verdict = not_covered(mesh, all[i], point, kInNoRegion);
      return trial;
    }
  }
  return trial;
}

Trial perturbed_cover_hanging(MeshUnderTest& mesh) {
  if (mesh.outside_class()) return {Verdict::not_applicable("the mesh is not made by subdivisions")};
  const std::vector<std::int32_t>& levels = mesh.mesh().levels;
  if (std::all_of(levels.begin(), levels.end(), [&](std::int32_t level) { return level == levels.front(); })) {
    return {Verdict::not_applicable("the mesh is uniform")};
  }
  return judge_hanging_cover(mesh.mesh(), perturbed_regions(mesh));
}

Trial judge_hanging_cover_repaired(const Mesh& mesh, const PerturbedRegions& regions) {
  Trial trial;
  const ActiveRegion active = active_region(mesh);
  for (const Hanging& hanging : all_hanging(mesh)) {
    const auto is_active = [&](const PerAxis<HalfRank>& point) { return in_region(active, point); };
    if (!any_corner(hanging.box, is_active) || !has_vertex_outside(mesh, active, hanging)) continue;
    ++trial.met;
    PerturbedRegions one_axis;
    one_axis[at(hanging.axis)] = regions[at(hanging.axis)];
    for (const PerAxis<HalfRank>& point : lattice_points(hanging.box)) {
      if (!in_region(active, point) || covered(one_axis, point)) continue;
      trial.verdict = not_covered(mesh, hanging, point, kNotInOwnRegion);
      return trial;
    }
  }
  return trial;
}

// Why it holds, given Lemma 3.5. Say K hangs along x, so that the node h or the edge e lies at x = q strictly between
// K's ends a < b. Elements that touch K are in its patch and have K in theirs, so that their levels differ from
// level(K) by at most 1. One that has a face at x = q is not larger than K along x and is divided along x more often:
// it has the level of a child of K, level(K) is 0 mod 3, and all elements that touch K are at least as large as K along
// y and z and have no side strictly inside K's y- and z-range. (1) K lies in supp B_w. Along x: the line through w
// along x has, between a and b, the entries of elements that touch K's edge there; if there were any, one of these
// elements would be divided along x, at all multiples of 1/m, at q too, and (q,w2,w3) would be in Xi_x. So b (or a, if
// w1 = b) is the entry next to w1. Along y and z the entry next to w in K's direction is K's other end, because
// elements that touch K have no side between. (2) If h is active it is in N_x(q), and supp B_h contains it. If an end
// of e is active, it is in N_x(q), and the entry next to it along e is e's other end (or farther), by the last sentence
// of the first paragraph: e lies in its support. So h (e within AR) lies in R_x(q): in the supports of w, not in
// N_x(q), and of a node in N_x(q).
Trial perturbed_cover_hanging_repaired(MeshUnderTest& mesh) {
  if (!mesh.admissible()) return {Verdict::not_applicable("the mesh is not admissible")};
  return judge_hanging_cover_repaired(mesh.mesh(), perturbed_regions(mesh));
}

}  // namespace asts
