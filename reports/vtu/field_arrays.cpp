#include "reports/vtu/drawn_mesh.hpp"
#include "reports/vtu/grid_builder.hpp"

namespace asts {

namespace {

VtuArray per_axis(std::string name, const PerAxis<int>& numbers) {
  return vtu_array(std::move(name), std::vector<std::int32_t>(numbers.begin(), numbers.end()), kDimension);
}

VtuArray one_number(std::string name, std::size_t number) {
  return vtu_array(std::move(name), std::vector<std::int32_t>{static_cast<std::int32_t>(number)});
}

/// The coordinates of each index vector of an axis, in the order of their numbers.
VtuArray vector_table(const DrawnMesh& drawn_mesh, Axis axis) {
  const IndexVectors& vectors = drawn_mesh.test.splines().vectors[at(axis)];
  std::vector<double> entries;
  for (std::int32_t id = 0; id < vectors.size(); ++id) {
    for (const std::int32_t rank : vectors[id]) entries.push_back(drawn(drawn_mesh.test.mesh().coordinate(axis, rank)));
  }
  return vtu_array(array_name("vectors", axis), entries, vectors.length());
}

VtuArray chosen_node(const DrawnMesh& drawn_mesh, std::int32_t node) {
  const PerAxis<std::int32_t>& ranks = drawn_mesh.test.splines().nodes[at(node)];
  std::vector<double> point;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    point.push_back(drawn(drawn_mesh.test.mesh().coordinate(axis, ranks[at(axis)])));
  }
  return vtu_array("chosen_node", point, kDimension);
}

template <class Mark>
void add_names(std::vector<VtuArray>& arrays, const char* name, const std::vector<Mark>& marks) {
  std::vector<std::string> names;
  for (const Mark& mark : marks) names.push_back(mark.name);
  if (!names.empty()) arrays.push_back(vtu_texts(name, names));
}

void add_words(std::vector<VtuArray>& arrays, const DrawnMesh& drawn_mesh, const VtuChoice::Decided& decided) {
  arrays.push_back(vtu_texts("statement", {decided.id}));
  arrays.push_back(vtu_texts("verdict", {outcome_name(decided.verdict.outcome)}));
  if (decided.verdict.witness) arrays.push_back(vtu_texts("witness_kind", {kind_of(*decided.verdict.witness)}));
  add_names(arrays, "witness_boxes", drawn_mesh.witness.boxes);
  add_names(arrays, "witness_nodes", drawn_mesh.witness.nodes);
  add_names(arrays, "witness_points", drawn_mesh.witness.points);
}

}  // namespace

std::vector<VtuArray> field_arrays(const DrawnMesh& drawn_mesh) {
  const Setting& setting = drawn_mesh.test.mesh().setting;
  const TSplines& splines = drawn_mesh.test.splines();
  std::vector<VtuArray> arrays;
  arrays.push_back(per_axis("degree", setting.degree));
  arrays.push_back(one_number("grading", at(setting.grading)));
  arrays.push_back(per_axis("domain", setting.domain));
  arrays.push_back(one_number("elements", drawn_mesh.test.mesh().elements.size()));
  arrays.push_back(one_number("active_nodes", splines.nodes.size()));
  for (Axis axis = 0; axis < kDimension && !splines.missing && splines.size() > 0; ++axis) {
    arrays.push_back(vector_table(drawn_mesh, axis));
  }
  if (drawn_mesh.choice.node) arrays.push_back(chosen_node(drawn_mesh, *drawn_mesh.choice.node));
  if (drawn_mesh.choice.decided) add_words(arrays, drawn_mesh, *drawn_mesh.choice.decided);
  return arrays;
}

}  // namespace asts
