#include "reports/vtu/drawn_mesh.hpp"
#include "reports/vtu/grid_builder.hpp"

namespace asts {

namespace {

/// A number for each active node; -1 for all other points.
template <class NumberOf>
VtuArray node_array(const DrawnMesh& drawn_mesh, std::string name, const NumberOf& number_of) {
  std::vector<std::int32_t> numbers(drawn_mesh.points, -1);
  for (std::size_t node = 0; node < drawn_mesh.node_points.size(); ++node) {
    numbers[at(drawn_mesh.node_points[node])] = number_of(node);
  }
  return vtu_array(std::move(name), numbers);
}

/// The witness's nodes by number, then its points. A node of another mesh is not shown.
VtuArray witness_array(const DrawnMesh& drawn_mesh) {
  const SliceMarks& witness = drawn_mesh.witness;
  std::vector<std::int32_t> marks(drawn_mesh.points, 0);
  std::int32_t number = 0;
  for (const SliceMarks::Node& mark : witness.nodes) {
    ++number;
    const auto node = active_node_at(drawn_mesh.test.mesh(), drawn_mesh.test.splines(), mark.info.node);
    if (node) marks[at(drawn_mesh.node_points[at(*node)])] = number;
  }
  for (std::size_t i = 0; i < witness.points.size(); ++i) marks[drawn_mesh.vertices.positions.size() + i] = ++number;
  return vtu_array("witness", marks);
}

double product(const Rational& x, const Rational& y, const Rational& z) {
  if (x == 0 || y == 0 || z == 0) return 0;
  return drawn(x * y * z);
}

/// B_v at the vertices of elements, at the witness's points and on the lattice, in the order of the points.
VtuArray value_array(const DrawnMesh& drawn_mesh) {
  const BlendingFunction& function = *drawn_mesh.function;
  PerAxis<std::vector<Rational>> factors;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    for (const Rational& line : drawn_mesh.test.mesh().coordinates[at(axis)]) {
      factors[at(axis)].push_back(function.factor(axis, line));
    }
  }
  std::vector<double> values;
  for (const PerAxis<std::int32_t>& p : drawn_mesh.vertices.positions) {
    values.push_back(product(factors[0][at(p[0])], factors[1][at(p[1])], factors[2][at(p[2])]));
  }
  for (const SliceMarks::Point& mark : drawn_mesh.witness.points) {
    const ExactPoint& p = mark.point;
    values.push_back(product(function.factor(0, p[0]), function.factor(1, p[1]), function.factor(2, p[2])));
  }
  for (const Rational& x : drawn_mesh.samples.factors[0]) {
    for (const Rational& y : drawn_mesh.samples.factors[1]) {
      for (const Rational& z : drawn_mesh.samples.factors[2]) values.push_back(product(x, y, z));
    }
  }
  return vtu_array("value", values);
}

}  // namespace

std::vector<VtuArray> point_arrays(const DrawnMesh& drawn_mesh) {
  const TSplines& splines = drawn_mesh.test.splines();
  std::vector<VtuArray> arrays;
  arrays.push_back(node_array(drawn_mesh, "node", [](std::size_t node) { return static_cast<std::int32_t>(node); }));
  for (Axis axis = 0; axis < kDimension && !splines.missing; ++axis) {
    arrays.push_back(node_array(drawn_mesh, array_name("vector", axis),
                                [&](std::size_t node) { return splines.vector_ids[node][at(axis)]; }));
  }
  if (drawn_mesh.function) arrays.push_back(value_array(drawn_mesh));
  const bool named = !drawn_mesh.witness.nodes.empty() || !drawn_mesh.witness.points.empty();
  if (named) arrays.push_back(witness_array(drawn_mesh));
  return arrays;
}

}  // namespace asts
