#include "properties/describe.hpp"

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

Rational tree_coordinate(const RefinementTree& tree, Axis axis, std::int32_t rank) {
  return tree.grid(axis).coordinate(tree.grid(axis).line_of_rank(rank));
}

PerturbationInfo describe_perturbation(MeshUnderTest& mesh, const PerAxis<HalfRank>& point, Axis axis) {
  const auto [in, out] = nodes_behind(mesh.splines(), mesh.bricks(), axis, point);
  return {axis, coordinate_of(mesh.mesh(), axis, point[at(axis)]), describe_node(mesh.mesh(), mesh.splines(), in),
          describe_node(mesh.mesh(), mesh.splines(), out)};
}

}  // namespace

ElementInfo describe_element(const Mesh& mesh, std::int32_t element) {
  ElementInfo info;
  const Box& box = mesh.elements[at(element)];
  for (Axis axis = 0; axis < kDimension; ++axis) {
    info.box.lower[at(axis)] = mesh.coordinate(axis, box.lower[at(axis)]);
    info.box.upper[at(axis)] = mesh.coordinate(axis, box.upper[at(axis)]);
  }
  if (mesh.levels[at(element)] != Mesh::kNoLevel) info.level = mesh.levels[at(element)];
  return info;
}

ElementInfo describe_tree_element(const RefinementTree& tree, std::int32_t id) {
  ElementInfo info;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    info.box.lower[at(axis)] = tree_coordinate(tree, axis, tree.extent(id, axis).lower);
    info.box.upper[at(axis)] = tree_coordinate(tree, axis, tree.extent(id, axis).upper);
  }
  info.level = tree.node(id).level;
  return info;
}

ExactBox describe_environment(const RefinementTree& tree, std::int32_t id) {
  ExactBox box;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    box.lower[at(axis)] = tree_coordinate(tree, axis, tree.environment(id, axis).lower);
    box.upper[at(axis)] = tree_coordinate(tree, axis, tree.environment(id, axis).upper);
  }
  return box;
}

void append_elements(ClaimWitness& witness, const std::string& name, const RefinementTree& tree,
                     const std::vector<std::int32_t>& elements) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    witness.values.emplace_back(name + " " + std::to_string(i + 1), describe_tree_element(tree, elements[i]));
  }
}

ActiveNodeInfo describe_node(const Mesh& mesh, const TSplines& splines, std::int32_t node) {
  ActiveNodeInfo info;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::size_t a = at(axis);
    info.node[a] = mesh.coordinate(axis, splines.nodes[at(node)][a]);
    for (const std::int32_t rank : splines.index_vector(node, axis)) {
      info.index_vectors[a].push_back(mesh.coordinate(axis, rank));
    }
    info.support.lower[a] = info.index_vectors[a].front();
    info.support.upper[a] = info.index_vectors[a].back();
  }
  return info;
}

RegionsMeetWitness describe_meeting(MeshUnderTest& mesh, const RegionsMeet& meeting) {
  ExactPoint point;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    point[at(axis)] = coordinate_of(mesh.mesh(), axis, meeting.point[at(axis)]);
  }
  return {point, describe_perturbation(mesh, meeting.point, meeting.first_axis),
          describe_perturbation(mesh, meeting.point, meeting.second_axis)};
}

Rational coordinate_of(const Mesh& mesh, Axis axis, HalfRank position) {
  if (position % 2 == 0) return mesh.coordinate(axis, position / 2);
  const int margin = (mesh.setting.degree[at(axis)] + 1) / 2;
  ensure(position == half_rank(mesh, axis, margin), "a position between lines is the active region's lower side");
  return margin;
}

}  // namespace asts
