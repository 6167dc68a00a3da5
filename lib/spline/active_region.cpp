#include "lib/spline/active_region.hpp"

namespace asts {

ActiveRegion active_region(const Mesh& mesh) {
  ActiveRegion region{};
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto a = at(axis);
    const int margin = (mesh.setting.degree[a] + 1) / 2;
    const int upper = mesh.setting.domain[a] - margin;
    if (upper < margin) {
      region.empty = true;
      continue;
    }
    region.lower[a] = half_rank(mesh, axis, margin);
    region.upper[a] = half_rank(mesh, axis, upper);
  }
  return region;
}

ActiveRegion whole_domain(const Mesh& mesh) {
  ActiveRegion domain{};
  for (std::size_t a = 0; a < kDimension; ++a) {
    domain.upper[a] = 2 * (static_cast<std::int32_t>(mesh.coordinates[a].size()) - 1);
  }
  return domain;
}

}  // namespace asts
