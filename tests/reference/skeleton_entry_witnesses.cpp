#include <algorithm>

#include "tests/reference/skeleton_kinds.hpp"
#include "tests/reference/spline_hypotheses.hpp"
#include "tests/reference/validate_kinds.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

void check_count(const json& value, int actual, const std::string& what) {
  if (read_count(value, what) != static_cast<std::size_t>(actual))
    throw Rejected(what + ": it is " + std::to_string(actual));
}

/// The point through which an index set runs: its coordinate along the axis is written as 0.
Point read_line(const Setting& setting, std::size_t axis, const json& value) {
  const Point point = read_point(value);
  for (std::size_t a = 0; a < dimension; ++a)
    if (point[a] < 0 || setting.domain[a] < point[a]) throw Rejected("point: it is not in the domain");
  if (point[axis] != 0) throw Rejected("point: its coordinate along the axis is not written as 0");
  return point;
}

std::string check_entry(ClaimSubject& subject, const json& witness, const std::string& hypothesis, bool long_enough) {
  const json& values = values_of(witness, {"axis", "point", "length", "degree", "entry", "index_set"});
  const Setting& setting = subject.setting();
  const Space<Rational> space = make_space<Rational>(setting, subject.mesh(), 1);
  const std::size_t axis = read_axis(values["axis"]);
  const int half = (setting.degree[axis] + 1) / 2, length = setting.domain[axis];
  if (long_enough && length < half - 1) throw Rejected("the domain is too short along the axis: nothing is said of it");
  check_count(values["length"], length, "length");
  check_count(values["degree"], setting.degree[axis], "degree");
  const Point point = read_line(setting, axis, values["point"]);
  const std::vector<Rational> set = global_index_set(space, axis, point);
  if (read_numbers(values["index_set"]) != set) throw Rejected("index_set: it is " + text(set));
  const Rational entry = read_number(values["entry"]);
  std::vector<Rational> named;
  for (int i = 0; i < half; ++i) named.insert(named.end(), {Rational(i), Rational(length - i)});
  if (std::find(named.begin(), named.end(), entry) == named.end())
    throw Rejected("entry: " + text(entry) + " is none that the note names");
  if (std::find(set.begin(), set.end(), entry) != set.end())
    throw Rejected("nothing is violated: the index set has the entry " + text(entry));
  return "Hypothesis:" + hypothesis + " Conclusion: along " + axis_name(axis) + " the degree is " +
         std::to_string(setting.degree[axis]) + " and the domain " + std::to_string(length) + " long, so that " +
         text(entry) + " is an entry that the note names; the global index set through " + text(point) + " is " +
         text(set) + ", without it.";
}

}  // namespace

std::string check_frame_entry(ClaimSubject& subject, const json& witness) {
  return check_entry(subject, witness, mesh_is_admissible(subject.setting(), subject.mesh()), false);
}

std::string check_frame_entry_repaired(ClaimSubject& subject, const json& witness) {
  return check_entry(subject, witness, made_by_subdivisions(subject.setting(), subject.mesh()), true);
}

std::string check_index_vector(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"axis", "node", "length", "choices", "index_set"});
  const Setting& setting = subject.setting();
  const std::string hypothesis = made_by_subdivisions(setting, subject.mesh());
  const Space<Rational> space = make_space<Rational>(setting, subject.mesh(), 1);
  const std::size_t axis = read_axis(values["axis"]);
  const Point v = read_point(values["node"]);
  const std::vector<Point> active = active_nodes(space);
  if (std::find(active.begin(), active.end(), v) == active.end()) throw Rejected(text(v) + " is no active node");
  check_count(values["length"], setting.degree[axis] + 2, "length");
  const std::vector<Rational> set = global_index_set(space, axis, v);
  if (read_numbers(values["index_set"]) != set) throw Rejected("index_set: it is " + text(set));
  const int half = (setting.degree[axis] + 1) / 2, count = static_cast<int>(set.size());
  int choices = 0;
  for (int middle = half; middle + half < count; ++middle)
    if (set[static_cast<std::size_t>(middle)] == v[axis]) ++choices;
  check_count(values["choices"], choices, "choices");
  if (choices == 1) throw Rejected("nothing is violated: there is exactly one choice");
  return "Hypothesis:" + hypothesis + " Conclusion: the global index set along " + axis_name(axis) +
         " through the active node " + text(v) + " is " + text(set) + ", with " + std::to_string(choices) +
         " choices of " + std::to_string(setting.degree[axis] + 2) + " consecutive entries around it, not 1.";
}

std::string check_perturbed_uniform_mesh(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"axis", "point", "in", "out"});
  const Setting& setting = subject.setting();
  std::string report = "Hypothesis:" + made_by_subdivisions(setting, subject.mesh());
  const std::optional<int> first = level(setting, subject.mesh().front());
  for (const Box& element : subject.mesh())
    if (level(setting, element) != first) throw Rejected("the mesh is not uniform: the claim says nothing about it");
  const Space<Rational> space = make_space<Rational>(setting, subject.mesh(), 1);
  report += " It is uniform, of level " + std::to_string(first.value()) + ". Conclusion:";
  return report + in_slice_perturbation(space, read_axis(values["axis"]), read_point(values["point"]),
                                        checked_active_node(space, values["in"], "in"),
                                        checked_active_node(space, values["out"], "out"));
}

}  // namespace asts::reference
