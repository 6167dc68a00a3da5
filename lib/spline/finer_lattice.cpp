#include "lib/spline/finer_lattice.hpp"

#include "lib/exact/errors.hpp"

namespace asts {

FinerLattice::FinerLattice(const Mesh& mesh, const Mesh& finer) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const std::vector<Rational>& lines = finer.coordinates[axis];
    std::size_t rank = 0;
    for (const Rational& coordinate : mesh.coordinates[axis]) {
      while (rank < lines.size() && lines[rank] != coordinate) ++rank;
      ensure(rank < lines.size(), "a refinement has the lines of the mesh");
      ranks_[axis].push_back(static_cast<std::int32_t>(rank));
    }
  }
}

PerAxis<std::int32_t> FinerLattice::node(const PerAxis<std::int32_t>& ranks) const {
  PerAxis<std::int32_t> result;
  for (Axis axis = 0; axis < kDimension; ++axis) result[at(axis)] = rank(axis, ranks[at(axis)]);
  return result;
}

Box FinerLattice::box(const Box& half_ranks) const {
  Box result;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto a = at(axis);
    const HalfRank lower = half_ranks.lower[a];
    const HalfRank upper = half_ranks.upper[a];
    result.lower[a] = 2 * rank(axis, lower / 2) + lower % 2;
    result.upper[a] = upper % 2 == 0 ? 2 * rank(axis, upper / 2) : 2 * rank(axis, upper / 2 + 1) - 1;
  }
  return result;
}

}  // namespace asts
