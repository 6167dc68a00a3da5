#pragma once

#include <cstdint>
#include <vector>

#include "lib/spline/rectangles.hpp"
#include "properties/mesh_under_test.hpp"
#include "properties/witness.hpp"

namespace asts {

/// One of the m-1 new faces {xi} x [y, y+y~] x [z, z+z~] and what the proof of Theorem 5.3 says about its slice. Nodes
/// are those of the hatted mesh.
struct NewFace {
  std::int32_t line = 0;             ///< the rank of xi
  std::vector<bool> members;         ///< N_x(xi); no new node is in it
  std::vector<bool> hatted_members;  ///< N^_x(xi)
  std::vector<bool> projected;       ///< v in N_A with (v_2, v_3) in the closed rectangle [y, y+y~] x [z, z+z~]
  /// Sigma: the slice S_x(xi) cut with the supports of the new active nodes.
  std::vector<Rectangle> sigma;
  /// The same with the nodes of `projected` that are not in N_x(xi) beside the new ones; see new-node-split-repaired.
  std::vector<Rectangle> large_sigma;
};

/// What the proof of Theorem 5.3 looks at: K in G and G^ = subdiv(G, K). All ranks are those of G^, which has every
/// line of G. The proof assumes level(K) = 0 mod 3 "without loss of generality": x, y, z there are role(0), role(1),
/// role(2) here, the axes renamed cyclically so that K is subdivided along the first.
struct SubdivisionStep {
  std::int32_t level = 0;
  Mesh mesh;                        ///< G^
  TSplines splines;                 ///< of G^
  Box element;                      ///< K
  std::vector<bool> is_new;         ///< of each node of `splines`: it is in N^_A \ N_A
  PerturbedRegions regions;         ///< of G
  PerturbedRegions hatted_regions;  ///< of G^
  std::vector<NewFace> faces;       ///< by ascending xi

  Axis role(int number) const { return (level + number) % kDimension; }
  Rational lower(Axis axis) const { return mesh.coordinate(axis, element.lower[at(axis)]); }
  Rational upper(Axis axis) const { return mesh.coordinate(axis, element.upper[at(axis)]); }
};

/// Gathers a step.
/// REQUIRES: a leaf of the tree of `before`, level-directed subdivisions only, all index vectors exist.
SubdivisionStep subdivision_step(MeshUnderTest& before, std::int32_t leaf);

/// Whether an active node of G has its projection on S_x(xi) in the new closed faces, that is, whether `projected` is
/// not empty. If not, the step changes nothing that the proof looks at: see may_change_splines.
bool reaches_active_nodes(MeshUnderTest& before, std::int32_t leaf);

/// K as a witness tells it.
ElementInfo describe_step_element(const SubdivisionStep& step);

}  // namespace asts
