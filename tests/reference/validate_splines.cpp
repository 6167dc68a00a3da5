#include <algorithm>

#include "tests/reference/suitability.hpp"
#include "tests/reference/validate_kinds.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

Box as_box(const BasicBox<Rational>& box) {
  return {box.lower, box.upper};
}

template <class T>
bool every_index_vector_exists(const Setting& setting, const Mesh& mesh, Grid scale) {
  return active_splines(make_space<T>(setting, mesh, scale)).has_value();
}

bool is_node(const Space<Rational>& space, const Point& v) {
  return std::any_of(space.elements.begin(), space.elements.end(), [&](const BasicBox<Rational>& k) {
    for (std::size_t a = 0; a < dimension; ++a)
      if (v[a] != k.lower[a] && v[a] != k.upper[a]) return false;
    return true;
  });
}

}  // namespace

ActiveNode<Rational> checked_active_node(const Space<Rational>& space, const json& value, const std::string& what) {
  const ActiveNodeText claimed = read_active_node(value, what);
  if (!is_node(space, claimed.node)) throw Rejected(what + ": " + text(claimed.node) + " is no node of the mesh");
  if (!in_closed(space.active, claimed.node))
    throw Rejected(what + ": " + text(claimed.node) + " is not in the active region " + text(as_box(space.active)));
  const auto actual = active_node(space, claimed.node);
  if (!actual) throw Rejected(what + ": " + text(claimed.node) + " has no index vector on some axis");
  for (std::size_t a = 0; a < dimension; ++a)
    if (claimed.vectors[a] != actual->vectors[a])
      throw Rejected(what + ": its index vector along " + axis_name(a) + " is " + text(actual->vectors[a]));
  if (!(claimed.support == as_box(actual->support)))
    throw Rejected(what + ": its support is " + text(as_box(actual->support)));
  return *actual;
}

std::string check_property_applies(const Setting& setting, const Mesh& mesh) {
  constexpr std::size_t largest = 20'000;
  if (mesh.size() > largest)
    return " That every other active node has its index vectors was not checked (more than 20000 elements).";
  const std::optional<Grid> scale = grid_scale(setting, mesh);
  const bool exist = scale ? every_index_vector_exists<Grid>(setting, mesh, *scale)
                           : every_index_vector_exists<Rational>(setting, mesh, 1);
  if (!exist) throw Rejected("an active node of the mesh has no index vector: the property does not apply");
  return " Every active node has its three index vectors.";
}

namespace {

/// One of the two slice perturbations; returns the sentence about it.
std::string check_slice(const Space<Rational>& space, const Point& t, const json& value, const std::string& what,
                        std::size_t& axis) {
  require_keys(value, {"axis", "slice", "in", "out"}, what);
  axis = read_axis(value["axis"]);
  const Rational q = read_number(value["slice"]);
  const ActiveNode<Rational> in = checked_active_node(space, value["in"], what + ": in");
  const ActiveNode<Rational> out = checked_active_node(space, value["out"], what + ": out");
  if (t[axis] != q) throw Rejected(what + ": the point is not in the slice");
  if (!in_closed(in.support, t)) throw Rejected(what + ": the point is not in the support of the node \"in\"");
  if (!in_closed(out.support, t)) throw Rejected(what + ": the point is not in the support of the node \"out\"");
  const std::string name = std::string("N_") + axis_name(axis) + "(" + text(q) + ")";
  if (!in_slice_nodes(space, axis, q, in.node)) throw Rejected(what + ": " + text(in.node) + " is not in " + name);
  if (in_slice_nodes(space, axis, q, out.node)) throw Rejected(what + ": " + text(out.node) + " is in " + name);
  return " " + text(in.node) + " is in " + name + " and has the closed support " + text(as_box(in.support)) + "; " +
         text(out.node) + " is an active node not in " + name + " and has the closed support " +
         text(as_box(out.support)) + "; t lies in both and in the slice, so it is in the perturbed region R_" +
         axis_name(axis) + ".";
}

}  // namespace

std::string validate_perturbed_regions_meet(const Setting& setting, const Mesh& mesh, const json& witness) {
  require_keys(witness, {"kind", "point", "first", "second"}, "the witness");
  const Space<Rational> space = make_space<Rational>(setting, mesh, 1);
  const Point t = read_point(witness["point"]);
  if (!in_closed(space.active, t))
    throw Rejected("point: " + text(t) + " is not in the active region " + text(as_box(space.active)));
  std::size_t first = 0, second = 0;
  const std::string one = check_slice(space, t, witness["first"], "first", first);
  const std::string two = check_slice(space, t, witness["second"], "second", second);
  if (first == second) throw Rejected("both perturbed regions are of the same axis");
  return "t = " + text(t) + " lies in the active region " + text(as_box(space.active)) + "." + one + two +
         check_property_applies(setting, mesh) +
         " Two perturbed regions have the common point t: the mesh is not analysis-suitable (Definition 5.2).";
}

namespace {

/// One axis of a pair that does not overlap there; returns the sentence about it.
std::string check_no_overlap(const ActiveNode<Rational>& v, const ActiveNode<Rational>& w, const json& value,
                             std::vector<std::size_t>& axes) {
  require_keys(value, {"axis", "coordinate", "in"}, "axes");
  const std::size_t axis = read_axis(value["axis"]);
  const std::string name = std::string("along ") + axis_name(axis);
  const Rational q = read_number(value["coordinate"]);
  if (value["in"] != "v" && value["in"] != "w") throw Rejected(name + ": \"in\" is neither v nor w");
  if (std::find(axes.begin(), axes.end(), axis) != axes.end()) throw Rejected(name + ": the axis is listed twice");
  axes.push_back(axis);
  const bool in_v = value["in"] == "v";
  const std::vector<Rational>& holder = (in_v ? v : w).vectors[axis];
  const std::vector<Rational>& other = (in_v ? w : v).vectors[axis];
  if (std::find(holder.begin(), holder.end(), q) == holder.end())
    throw Rejected(name + ": " + text(q) + " is not in the vector " + text(holder));
  if (std::find(other.begin(), other.end(), q) != other.end())
    throw Rejected(name + ": " + text(q) + " is in the other vector " + text(other));
  if (q < other.front() || other.back() < q)
    throw Rejected(name + ": " + text(q) + " is not within the range of " + text(other));
  if (overlap(v.vectors[axis], w.vectors[axis])) throw Rejected(name + ": the vectors overlap");
  return std::string(" Along ") + axis_name(axis) + " the coordinate " + text(q) + " is in " + text(holder) +
         ", is within the closed range of " + text(other) + ", and is no entry of it: no overlap, by (6.1).";
}

}  // namespace

std::string validate_no_partial_overlap(const Setting& setting, const Mesh& mesh, const json& witness) {
  require_keys(witness, {"kind", "v", "w", "axes"}, "the witness");
  const Space<Rational> space = make_space<Rational>(setting, mesh, 1);
  const ActiveNode<Rational> v = checked_active_node(space, witness["v"], "v");
  const ActiveNode<Rational> w = checked_active_node(space, witness["w"], "w");
  if (!intersect_with_volume(v.support, w.support))
    throw Rejected("the intersection of the supports has no positive volume");
  if (!witness["axes"].is_array()) throw Rejected("axes is not a list");
  std::vector<std::size_t> axes;
  std::string sentences;
  for (const json& value : witness["axes"]) sentences += check_no_overlap(v, w, value, axes);
  if (axes.size() < 2) throw Rejected("fewer than two axes without overlap");
  return "v = " + text(v.node) + " with support " + text(as_box(v.support)) + " and w = " + text(w.node) +
         " with support " + text(as_box(w.support)) + " are active nodes, and the intersection of their supports has "
         "positive volume." + sentences + check_property_applies(setting, mesh) + " They overlap along " +
         std::to_string(dimension - axes.size()) + " axes at most where Definition 6.3 asks for 2: the mesh is not "
         "dual-compatible (Definition 6.4).";
}

}  // namespace asts::reference
