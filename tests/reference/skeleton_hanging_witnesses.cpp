#include <algorithm>

#include "tests/reference/skeleton_claims.hpp"
#include "tests/reference/skeleton_kinds.hpp"
#include "tests/reference/spline_hypotheses.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

/// A node or edge that hangs on an element, with a point of it.
struct HangingText {
  std::size_t axis;
  Box hanging, element;
  Point point;
};

/// Definition 5.1, as lib/spline/hanging.hpp reads it: on which element, and along which axis, is checked here.
HangingText read_hanging(ClaimSubject& subject, const json& values, bool is_node) {
  const Mesh& mesh = subject.mesh();
  const std::size_t position = position_of_element(subject.setting(), mesh, values["element"], "element");
  const HangingText result{read_axis(values["axis"]), read_box(values["hanging"], "hanging"), mesh[position],
                           read_point(values["point"])};
  if ((result.hanging.lower == result.hanging.upper) != is_node)
    throw Rejected(is_node ? "hanging: it is no point" : "hanging: it is a point");
  if (!(is_node ? is_node_of(mesh, result.hanging.lower) : is_edge_of(mesh, result.hanging)))
    throw Rejected("hanging: " + text(result.hanging) +
                   (is_node ? " is no node of the mesh" : " is no edge of an element"));
  if (!hangs_on(result.hanging, result.element)) throw Rejected("hanging: it does not hang on the element");
  const Rational& q = result.hanging.lower[result.axis];
  if (read_number(values["slice"]) != q || result.hanging.upper[result.axis] != q)
    throw Rejected("slice: the node or edge is not in it");
  if (q <= result.element.lower[result.axis] || result.element.upper[result.axis] <= q)
    throw Rejected("axis: the element does not go on at either side of the node or edge");
  for (std::size_t a = 0; a < dimension; ++a)
    if (result.point[a] < result.hanging.lower[a] || result.hanging.upper[a] < result.point[a])
      throw Rejected("point: it is not on the node or edge");
  return result;
}

std::string described_hanging(const HangingText& h, bool is_node) {
  return std::string(is_node ? "the node " + text(h.hanging.lower) : "the edge " + text(h.hanging)) + " hangs along " +
         axis_name(h.axis) + " on the element " + text(h.element);
}

std::vector<ActiveNode<Rational>> splines_of(const Space<Rational>& space) {
  auto splines = active_splines(space);
  if (!splines) throw Rejected("an active node of the mesh has no index vector");
  return std::move(*splines);
}

void require_not_uniform(const Setting& setting, const Mesh& mesh) {
  for (const Box& element : mesh)
    if (level(setting, element) != level(setting, mesh.front())) return;
  throw Rejected("the mesh is uniform: the claim says nothing about it");
}

std::string check_cover(ClaimSubject& subject, const json& witness, bool is_node) {
  const json& values = values_of(witness, {"axis", "hanging", "element", "point", "slice"});
  const std::string hypothesis = made_by_subdivisions(subject.setting(), subject.mesh());
  require_not_uniform(subject.setting(), subject.mesh());
  const HangingText h = read_hanging(subject, values, is_node);
  const Space<Rational> space = make_space<Rational>(subject.setting(), subject.mesh(), 1);
  const std::vector<ActiveNode<Rational>> splines = splines_of(space);
  for (std::size_t a = 0; a < dimension; ++a)
    if (in_perturbed_region(space, splines, a, h.point))
      throw Rejected("nothing is violated: " + text(h.point) + " is in R_" + axis_name(a));
  return "Hypothesis:" + hypothesis + " It is not uniform. Conclusion: " + described_hanging(h, is_node) +
         "; its point " + text(h.point) + " is in none of the three perturbed regions, as decided from the " +
         std::to_string(splines.size()) + " active nodes of the active region " + text(as_box(space.active)) + ".";
}

/// An active vertex w of the element with (q, w2, w3) outside the skeleton.
Point vertex_outside(const Space<Rational>& space, const HangingText& h) {
  for (const Rational& x : {h.element.lower[0], h.element.upper[0]})
    for (const Rational& y : {h.element.lower[1], h.element.upper[1]})
      for (const Rational& z : {h.element.lower[2], h.element.upper[2]}) {
        const Point w{x, y, z};
        if (in_closed(space.active, w) && !in_slice_nodes(space, h.axis, h.hanging.lower[h.axis], w)) return w;
      }
  throw Rejected("the element has no active vertex outside of the slice's nodes: the claim says nothing about it");
}

std::string check_cover_repaired(ClaimSubject& subject, const json& witness, bool is_node) {
  const json& values = values_of(witness, {"axis", "hanging", "element", "point", "slice"});
  const std::string hypothesis = mesh_is_admissible(subject.setting(), subject.mesh());
  const HangingText h = read_hanging(subject, values, is_node);
  const Space<Rational> space = make_space<Rational>(subject.setting(), subject.mesh(), 1);
  if (!in_closed(space.active, h.hanging.lower) && !in_closed(space.active, h.hanging.upper))
    throw Rejected("hanging: it has no end in the active region");
  const Point w = vertex_outside(space, h);
  if (!in_closed(space.active, h.point)) throw Rejected("point: it is not in the active region");
  if (in_perturbed_region(space, splines_of(space), h.axis, h.point))
    throw Rejected("nothing is violated: " + text(h.point) + " is in R_" + axis_name(h.axis));
  return "Hypothesis:" + hypothesis + " " + described_hanging(h, is_node) + ", whose active vertex " + text(w) +
         " is not in " + slice_name(h.axis, h.hanging.lower[h.axis]) + ". Conclusion: its point " + text(h.point) +
         " is in the active region and not in R_" + axis_name(h.axis) + ".";
}

}  // namespace

std::string check_hanging_node(ClaimSubject& subject, const json& witness) {
  return check_cover(subject, witness, true);
}
std::string check_hanging_edge(ClaimSubject& subject, const json& witness) {
  return check_cover(subject, witness, false);
}
std::string check_hanging_node_repaired(ClaimSubject& subject, const json& witness) {
  return check_cover_repaired(subject, witness, true);
}
std::string check_hanging_edge_repaired(ClaimSubject& subject, const json& witness) {
  return check_cover_repaired(subject, witness, false);
}

}  // namespace asts::reference
