#include <algorithm>

#include "lib/mesh/mesh.hpp"

namespace asts {

namespace {

std::size_t at(std::int32_t id) { return static_cast<std::size_t>(id); }

struct ExactBox {
  PerAxis<Rational> lower;
  PerAxis<Rational> upper;
};

ExactBox exact_box(const Mesh& mesh, const Box& box) {
  ExactBox result;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    result.lower[at(axis)] = mesh.coordinate(axis, box.lower[at(axis)]);
    result.upper[at(axis)] = mesh.coordinate(axis, box.upper[at(axis)]);
  }
  return result;
}

std::int32_t whole_part(const Rational& value) {
  return static_cast<std::int32_t>(
      Integer(boost::multiprecision::numerator(value) / boost::multiprecision::denominator(value)));
}

/// The unit cube that contains a box's lower corner.
PerAxis<std::int32_t> cube_of(const ExactBox& box) {
  PerAxis<std::int32_t> index{};
  for (std::size_t axis = 0; axis < kDimension; ++axis) index[axis] = whole_part(box.lower[axis]);
  return index;
}

/// The children to choose, level by level, on the way from a unit cube down to a box; nothing if the box is none of the
/// elements below the cube. `place` and `size` are the box's lower corner and side lengths relative to the element at
/// hand, in its side lengths, so that the numbers stay as short as the box's own.
std::optional<std::vector<std::int32_t>> path_to(const ExactBox& box, const PerAxis<std::int32_t>& cube, int grading) {
  PerAxis<Rational> place;
  PerAxis<Rational> size;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    place[axis] = box.lower[axis] - cube[axis];
    size[axis] = box.upper[axis] - box.lower[axis];
    if (size[axis] > 1) return std::nullopt;
  }
  std::vector<std::int32_t> path;
  // ends: each round makes a size grow by m, and none passes 1
  while (std::any_of(size.begin(), size.end(), [](const Rational& s) { return s != 1; })) {
    const std::size_t axis = path.size() % kDimension;
    place[axis] *= grading;
    size[axis] *= grading;
    if (size[axis] > 1) return std::nullopt;
    path.push_back(whole_part(place[axis]));
    place[axis] -= path.back();
  }
  const bool aligned = std::all_of(place.begin(), place.end(), [](const Rational& p) { return p == 0; });
  return aligned ? std::optional(std::move(path)) : std::nullopt;
}

std::int32_t find_or_make(RefinementTree& tree, const ExactBox& box) {
  const PerAxis<std::int32_t> cube = cube_of(box);
  const auto path = path_to(box, cube, tree.setting().grading);
  if (!path) return RefinementTree::kNone;
  std::int32_t id = tree.unit_cube(cube);
  for (const std::int32_t child : *path) {
    if (tree.is_leaf(id)) tree.subdivide(id);
    id = tree.node(id).first_child + child;
  }
  return id;
}

}  // namespace

bool RecognisedTree::complete() const {
  return std::find(node_of_element.begin(), node_of_element.end(), RefinementTree::kNone) == node_of_element.end();
}

RecognisedTree recognise(const Mesh& mesh) {
  RecognisedTree result{RefinementTree(mesh.setting), {}};
  result.node_of_element.reserve(mesh.elements.size());
  for (const Box& box : mesh.elements) {
    result.node_of_element.push_back(find_or_make(result.tree, exact_box(mesh, box)));
  }
  result.tree.update_ranks();
  return result;
}

}  // namespace asts
