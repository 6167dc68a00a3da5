#pragma once

#include "lib/mesh/mesh.hpp"
#include "lib/spline/index_sets.hpp"
#include "properties/witness.hpp"

namespace asts {

/// A closed box of half ranks: even ends are lines, odd ones the open intervals between them.
struct HalfBox {
  PerAxis<HalfRank> lower;
  PerAxis<HalfRank> upper;
};

/// The interior of a box between lines: the closed elements that meet it share volume with the box.
inline HalfBox interior_of(const Box& box) {
  HalfBox result;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    result.lower[axis] = 2 * box.lower[axis] + 1;
    result.upper[axis] = 2 * box.upper[axis] - 1;
  }
  return result;
}

/// The same of any box of the domain that has volume, also where no line of the mesh runs along its sides.
HalfBox interior_of(const Mesh& mesh, const ExactBox& box);

/// Walks down a mesh's hierarchy of cuts.
template <class Visit>
class ElementSearch {
 public:
  ElementSearch(const Mesh& mesh, const HalfBox& box, const Visit& visit) : mesh_(mesh), box_(box), visit_(visit) {}

  void run() {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if (box_.lower[axis] > box_.upper[axis]) return;
    }
    Box domain{};
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      domain.upper[axis] = static_cast<std::int32_t>(mesh_.coordinates[axis].size()) - 1;
    }
    descend(mesh_.locator.nodes.front(), domain);
  }

 private:
  void descend(const Locator::Node& node, const Box& extent) {
    if (node.axis < 0) {
      visit_(node.first);
      return;
    }
    const std::size_t a = at(node.axis);
    for (std::int32_t child = 0; child < node.count; ++child) {
      Box part = extent;
      part.lower[a] = mesh_.locator.nodes[at(node.first + child)].lower;
      if (child + 1 < node.count) part.upper[a] = mesh_.locator.nodes[at(node.first + child + 1)].lower;
      if (2 * part.lower[a] > box_.upper[a] || 2 * part.upper[a] < box_.lower[a]) continue;
      descend(mesh_.locator.nodes[at(node.first + child)], part);
    }
  }

  const Mesh& mesh_;
  const HalfBox& box_;
  const Visit& visit_;
};

/// Calls visit(element) for each closed element that meets a closed box, once each.
/// Cost: linear in what meets the box, times the depth of the mesh's hierarchy.
template <class Visit>
void for_each_element_meeting(const Mesh& mesh, const HalfBox& box, const Visit& visit) {
  ElementSearch<Visit>(mesh, box, visit).run();
}

}  // namespace asts
