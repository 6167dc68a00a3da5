#include "reports/vtu/element_marks.hpp"

#include "reports/vtu/element_search.hpp"

namespace asts {

namespace {

bool inside_domain(const Setting& setting, const ExactBox& box) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (box.lower[axis] < 0 || box.upper[axis] > setting.domain[axis] || box.lower[axis] > box.upper[axis])
      return false;
  }
  return true;
}

}  // namespace

std::vector<std::uint8_t> marks_of_support(MeshUnderTest& mesh, std::int32_t node) {
  std::vector<std::uint8_t> marks(mesh.mesh().elements.size(), 0);
  Box support{};
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval range = mesh.splines().support(node, axis);
    support.lower[at(axis)] = range.lower;
    support.upper[at(axis)] = range.upper;
  }
  for_each_element_meeting(mesh.mesh(), interior_of(support), [&](std::int32_t element) { marks[at(element)] = 1; });
  return marks;
}

std::vector<std::int32_t> marks_of_boxes(const Mesh& mesh, const std::vector<ExactBox>& boxes) {
  std::vector<std::int32_t> marks(mesh.elements.size(), 0);
  std::int32_t number = 0;
  for (const ExactBox& box : boxes) {
    ++number;
    if (!inside_domain(mesh.setting, box)) continue;
    for_each_element_meeting(mesh, interior_of(mesh, box), [&](std::int32_t element) {
      if (marks[at(element)] == 0) marks[at(element)] = number;
    });
  }
  return marks;
}

std::vector<std::uint8_t> marks_of_perturbed_region(MeshUnderTest& mesh, Axis axis) {
  std::vector<std::uint8_t> marks(mesh.mesh().elements.size(), 0);
  for (const Box& box : mesh.perturbed_regions()[at(axis)]) {
    for_each_element_meeting(mesh.mesh(), HalfBox{box.lower, box.upper},
                             [&](std::int32_t element) { marks[at(element)] = 1; });
  }
  return marks;
}

}  // namespace asts
