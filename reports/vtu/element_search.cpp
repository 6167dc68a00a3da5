#include "reports/vtu/element_search.hpp"

namespace asts {

HalfBox interior_of(const Mesh& mesh, const ExactBox& box) {
  HalfBox result;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const HalfRank lower = half_rank(mesh, axis, box.lower[at(axis)]);
    const HalfRank upper = half_rank(mesh, axis, box.upper[at(axis)]);
    result.lower[at(axis)] = lower + (lower % 2 == 0 ? 1 : 0);
    result.upper[at(axis)] = upper - (upper % 2 == 0 ? 1 : 0);
  }
  return result;
}

}  // namespace asts
