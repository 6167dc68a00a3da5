#include "tests/reference/spline_hypotheses.hpp"

#include <algorithm>

#include "tests/reference/tree.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

/// Calls decide(space, splines) in integers where they fit, else in rationals. Rejects meshes without splines.
template <class T, class Decide>
bool decide_in(const Setting& setting, const Mesh& mesh, Grid scale, const Decide& decide) {
  const Space<T> space = make_space<T>(setting, mesh, scale);
  const auto splines = active_splines(space);
  if (!splines) throw Rejected("an active node of the mesh has no index vector: the claim says nothing about the mesh");
  if (splines->empty()) throw Rejected("the mesh has no active node: the claim says nothing about it");
  return decide(space, *splines);
}

template <class Decide>
bool with_splines(const Setting& setting, const Mesh& mesh, const Decide& decide) {
  if (const auto scale = grid_scale(setting, mesh)) return decide_in<Grid>(setting, mesh, *scale, decide);
  return decide_in<Rational>(setting, mesh, 1, decide);
}

[[noreturn]] void not_met(const std::string& hypothesis) {
  throw Rejected(hypothesis + ": the claim says nothing about it");
}

template <class T>
bool supports_meet(const ActiveNode<T>& v, const ActiveNode<T>& w) {
  return closed_intersection(v.support, w.support).has_value();
}

}  // namespace

std::string made_by_subdivisions(const Setting& setting, const Mesh& mesh) {
  if (!refinement_tree(setting, mesh).outside.empty()) not_met("the mesh is not made by subdivisions");
  return " The mesh is made by level-directed subdivisions of the initial mesh.";
}

std::string mesh_is_admissible(const Setting& setting, const Mesh& mesh) {
  if (!admissible_mesh(setting, mesh, refinement_tree(setting, mesh))) not_met("the mesh is not admissible");
  return " The mesh is admissible (Definition 3.2).";
}

std::string splines_exist(const Setting& setting, const Mesh& mesh) {
  with_splines(setting, mesh, [](const auto&, const auto&) { return true; });
  return " Every active node has its three index vectors.";
}

std::string mesh_is_suitable(const Setting& setting, const Mesh& mesh) {
  const bool suitable = with_splines(setting, mesh, [](const auto& space, const auto& splines) {
    return analysis_suitable_by_rectangles(space, splines);
  });
  if (!suitable) not_met("the mesh is not analysis-suitable");
  return " The mesh is analysis-suitable (Definition 5.2).";
}

std::string suitable_in_whole_domain(const Setting& setting, const Mesh& mesh) {
  const bool suitable = with_splines(setting, mesh, [](const auto& space, const auto& splines) {
    return analysis_suitable_by_rectangles(with_whole_domain(space), splines);
  });
  if (!suitable) not_met("with slices of the closed domain the mesh is not analysis-suitable");
  return " With slices of the closed domain the mesh is analysis-suitable.";
}

std::string mesh_is_compatible(const Setting& setting, const Mesh& mesh) {
  const bool compatible = with_splines(
      setting, mesh, [](const auto&, const auto& splines) { return !not_dual_compatible(splines).has_value(); });
  if (!compatible) not_met("the mesh is not dual-compatible");
  return " The mesh is dual-compatible (Definition 6.4).";
}

std::string touching_pairs_overlap(const Setting& setting, const Mesh& mesh) {
  const bool overlapping = with_splines(setting, mesh, [](const auto&, const auto& splines) {
    for (const auto& v : splines)
      for (const auto& w : splines)
        if (supports_meet(v, w) && !partially_overlap(v, w)) return false;
    return true;
  });
  if (!overlapping) not_met("two active nodes of the mesh whose closed supports meet do not partially overlap");
  return " Any two active nodes whose closed supports meet partially overlap.";
}

template <class T>
Space<T> with_whole_domain(Space<T> space) {
  space.active = space.elements.front();
  for (const BasicBox<T>& element : space.elements)
    for (std::size_t a = 0; a < dimension; ++a) {
      space.active.lower[a] = std::min(space.active.lower[a], element.lower[a]);
      space.active.upper[a] = std::max(space.active.upper[a], element.upper[a]);
    }
  return space;
}

template Space<Rational> with_whole_domain(Space<Rational>);
template Space<Grid> with_whole_domain(Space<Grid>);

std::size_t position_of_element(const Setting& setting, const Mesh& mesh, const json& value, const std::string& what) {
  const ElementText claimed = read_element(value, what);
  const auto found = std::find(mesh.begin(), mesh.end(), claimed.box);
  if (found == mesh.end()) throw Rejected(what + ": " + text(claimed.box) + " is no element of the mesh");
  const std::optional<int> actual = level(setting, claimed.box);
  if (actual.has_value() != claimed.level.has_value() || (actual && *actual != *claimed.level))
    throw Rejected(what + ": its level is " + (actual ? std::to_string(*actual) : "no integer") + ", not as printed");
  return static_cast<std::size_t>(found - mesh.begin());
}

bool read_choice(const json& value, const char* yes, const char* no, const std::string& what) {
  if (value == yes) return true;
  if (value == no) return false;
  throw Rejected(what + " is neither \"" + yes + "\" nor \"" + no + "\"");
}

std::string slice_name(std::size_t axis, const Rational& q) {
  return std::string("N_") + axis_name(axis) + "(" + text(q) + ")";
}

Box as_box(const BasicBox<Rational>& box) { return {box.lower, box.upper}; }

std::string described_node(const ActiveNode<Rational>& v) {
  return text(v.node) + " with support " + text(as_box(v.support));
}

std::string described_vector(const ActiveNode<Rational>& v, std::size_t axis) {
  return std::string(axis_name(axis)) + axis_name(axis) + text(v.node) + " = " + text(v.vectors[axis]);
}

std::string in_slice_perturbation(const Space<Rational>& space, std::size_t axis, const Point& t,
                                  const ActiveNode<Rational>& in, const ActiveNode<Rational>& out) {
  const std::string name = slice_name(axis, t[axis]);
  if (!in_closed(space.active, t)) throw Rejected("the point " + text(t) + " is not in " + text(as_box(space.active)));
  for (const ActiveNode<Rational>* v : {&in, &out})
    if (!in_closed(v->support, t))
      throw Rejected("the point " + text(t) + " is not in the support " + text(as_box(v->support)) + " of " +
                     text(v->node));
  if (!in_slice_nodes(space, axis, t[axis], in.node)) throw Rejected(text(in.node) + " is not in " + name);
  if (in_slice_nodes(space, axis, t[axis], out.node)) throw Rejected(text(out.node) + " is in " + name);
  return " " + described_node(in) + " is in " + name + "; " + described_node(out) +
         " is not; both supports contain t = " + text(t) + ", which is therefore in R_" + axis_name(axis) + ".";
}

}  // namespace asts::reference
