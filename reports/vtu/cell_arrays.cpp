#include <algorithm>
#include <limits>

#include "reports/vtu/drawn_mesh.hpp"
#include "reports/vtu/element_marks.hpp"

namespace asts {

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

template <class Number>
std::int64_t marked(const std::vector<Number>& marks) {
  return std::count_if(marks.begin(), marks.end(), [](Number mark) { return mark != 0; });
}

/// Numbers of elements, which are the first cells, with one number for all other cells.
template <class Number>
VtuArray cell_array(const DrawnMesh& drawn_mesh, std::string name, std::vector<Number> numbers, Number others) {
  numbers.resize(drawn_mesh.kinds.size(), others);
  return vtu_array(std::move(name), numbers);
}

std::vector<double> levels_of(const Mesh& mesh) {
  std::vector<double> levels;
  for (const std::int32_t level : mesh.levels) levels.push_back(level == Mesh::kNoLevel ? kNoNumber : level);
  return levels;
}

VtuArray support_array(const DrawnMesh& drawn_mesh, VtuCounts& counts) {
  std::vector<std::uint8_t> marks = marks_of_support(drawn_mesh.test, *drawn_mesh.choice.node);
  counts.support_elements = marked(marks);
  marks.resize(drawn_mesh.kinds.size() - static_cast<std::size_t>(counts.samples), 0);
  return cell_array(drawn_mesh, "support", std::move(marks), std::uint8_t{1});
}

VtuArray witness_array(const DrawnMesh& drawn_mesh, VtuCounts& counts) {
  std::vector<ExactBox> boxes;
  for (const SliceMarks::Box& mark : drawn_mesh.witness.boxes) boxes.push_back(mark.box);
  std::vector<std::int32_t> marks = marks_of_boxes(drawn_mesh.test.mesh(), boxes);
  counts.witness_elements = marked(marks);
  return cell_array(drawn_mesh, "witness", std::move(marks), 0);
}

}  // namespace

std::vector<VtuArray> cell_arrays(const DrawnMesh& drawn_mesh, VtuCounts& counts) {
  std::vector<VtuArray> arrays;
  arrays.push_back(vtu_array("kind", drawn_mesh.kinds));
  arrays.push_back(cell_array(drawn_mesh, "level", levels_of(drawn_mesh.test.mesh()), kNoNumber));
  if (drawn_mesh.choice.node) arrays.push_back(support_array(drawn_mesh, counts));
  if (!drawn_mesh.witness.boxes.empty()) arrays.push_back(witness_array(drawn_mesh, counts));
  if (!drawn_mesh.choice.perturbed_regions || drawn_mesh.test.splines().missing) return arrays;
  counts.perturbed.emplace();
  for (Axis axis = 0; axis < kDimension; ++axis) {
    std::vector<std::uint8_t> marks = marks_of_perturbed_region(drawn_mesh.test, axis);
    (*counts.perturbed)[at(axis)] = marked(marks);
    arrays.push_back(cell_array(drawn_mesh, array_name("perturbed", axis), std::move(marks), std::uint8_t{0}));
  }
  return arrays;
}

}  // namespace asts
