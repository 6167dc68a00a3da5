#pragma once

#include "tests/reference/mesh.hpp"

namespace asts::reference {

/// The statements of the proof of Theorem 5.3 for G and K, with G^ = subdiv(G, K), literally: sets of nodes as lists,
/// unions of closed rectangles compared point by point. No hypothesis is asked for. x, y, z of the proof are the axis
/// along which K is subdivided and the next two, cyclically.
struct Theorem53Step {
  bool kept_regions;       ///< R^_y = R_y, R^_z = R_z, R^_x(q) = R_x(q) for all q that are no xi
  bool sigma_unperturbed;  ///< Sigma meets neither R^_y nor R^_z, for each xi
  bool split;              ///< both lines of the display of N^_x(xi), for each xi
  /// The same with the old nodes that project into the new closed face; their supports add nothing to Sigma, and
  /// R^_x(xi) lies in R_x(xi) u Sigma.
  bool split_repaired;
  bool second_patch_sizes;  ///< elements of the second-order patch are no larger than K along x and y
  bool sigma_extent;        ///< the boxes for Sigma and for (w_1, w_2), eps half of K's size along each axis

  bool operator==(const Theorem53Step&) const = default;
};

/// REQUIRES: K, the element at the position, has a level; all index vectors exist; 64 bits hold the grid.
Theorem53Step decide_theorem_5_3_step(const Setting& setting, const Mesh& mesh, std::size_t element);

/// Whether the display of N^_x(xi) is refuted on a mesh: the mesh is admissible and analysis-suitable, and the split
/// fails for an element with level(K) = 0 mod 3 whose subdivision is admissible.
bool refutes_new_node_split(const Setting& setting, const Mesh& mesh);

}  // namespace asts::reference
