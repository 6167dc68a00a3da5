#include "properties/splines_needed.hpp"

#include <string>

namespace asts {

Verdict without_active_nodes(bool region_is_empty) {
  return Verdict::not_applicable(region_is_empty ? "the active region is empty: no active node" : "no active node");
}

std::optional<Verdict> lacks_splines(MeshUnderTest& mesh) {
  const TSplines& splines = mesh.splines();
  if (splines.size() == 0) return without_active_nodes(splines.region.empty);
  if (!splines.missing) return std::nullopt;
  std::string node;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto a = at(axis);
    node += (axis == 0 ? "(" : ", ") + to_string(mesh.mesh().coordinate(axis, splines.missing->node[a]));
  }
  return Verdict::not_applicable("the active node " + node + ") has no local index vector along " +
                                 axis_name(splines.missing->axis) + ": its global index set has too few entries");
}

}  // namespace asts
