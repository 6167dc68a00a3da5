#pragma once

#include "lib/spline/index_sets.hpp"

namespace asts {

/// The lines of a mesh among those of a refinement of it: what was decided on the ranks of the one mesh is said again
/// on the ranks of the other, so that both can be compared.
///
/// Laws (tests/spline/finer_lattice_test.cpp): (1) a line keeps its coordinate; (2) a box of half ranks stays the same
/// set of points: an open interval between neighbouring lines becomes the lines and intervals that it now consists of.
class FinerLattice {
 public:
  /// REQUIRES: every line of `mesh` is a line of `finer`.
  FinerLattice(const Mesh& mesh, const Mesh& finer);

  std::int32_t rank(Axis axis, std::int32_t rank) const { return ranks_[at(axis)][at(rank)]; }
  PerAxis<std::int32_t> node(const PerAxis<std::int32_t>& ranks) const;
  /// A box of half ranks, as perturbed_region gives it.
  Box box(const Box& half_ranks) const;

 private:
  PerAxis<std::vector<std::int32_t>> ranks_;
};

}  // namespace asts
