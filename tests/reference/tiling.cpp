#include <algorithm>

#include "tests/reference/grid.hpp"

namespace asts::reference {

namespace {

/// Do no two of the boxes have common interior? Sorted by lower x, a box can only meet the interior of those that begin
/// before it ends; each pair is looked at once.
template <class T>
bool interiors_disjoint(const Mesh& mesh, Grid scale) {
  std::vector<BasicBox<T>> boxes;
  for (const Box& box : mesh) boxes.push_back(in_units<T>(box, scale));
  std::sort(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) { return a.lower < b.lower; });
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].lower[0] < boxes[i].upper[0]; ++j) {
      bool common = true;
      for (std::size_t a = 0; a < dimension && common; ++a)
        common = boxes[i].lower[a] < boxes[j].upper[a] && boxes[j].lower[a] < boxes[i].upper[a];
      if (common) return false;
    }
  return true;
}

}  // namespace

bool tiles_domain(const Setting& setting, const Mesh& mesh) {
  Box domain;
  for (std::size_t a = 0; a < dimension; ++a) {
    domain.lower[a] = 0;
    domain.upper[a] = setting.domain[a];
  }
  Rational sum = 0;
  for (const Box& box : mesh) {
    for (std::size_t a = 0; a < dimension; ++a)
      if (!(box.lower[a] < box.upper[a])) return false;
    if (!contains(domain, box)) return false;
    sum += volume(box);
  }
  if (sum != volume(domain)) return false;
  const std::optional<Grid> scale = grid_scale(setting, mesh);
  return scale ? interiors_disjoint<Grid>(mesh, *scale) : interiors_disjoint<Rational>(mesh, 1);
}

}  // namespace asts::reference
