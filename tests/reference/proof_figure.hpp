#pragma once

#include <map>
#include <string>

#include "tests/reference/suitability.hpp"

/// The figures in the proof of Theorem 5.3, the yz-view on the slice S_x(xi) for m = 2 and level(K) = 3: 17 x 21 unit
/// squares, read from the drawing's coordinates (or from the repaired claim's statement).
namespace asts::reference {

/// A closed rectangle (y, z).
struct DrawnRectangle {
  std::array<Rational, 2> lower, upper;
  bool contains(const std::array<Rational, 2>& place) const;
};
using DrawnSet = std::vector<DrawnRectangle>;

struct DrawnProofFigure {
  std::array<DrawnRectangle, 3> levels;  ///< where the level is at least 1, 2, 3
  DrawnRectangle k;
  std::map<std::string, DrawnSet> sets;  ///< "patch", "second-order patch", "Sigma", "Rx", "Ry", "Rz"
};

DrawnProofFigure printed_proof_figure();
DrawnProofFigure repaired_proof_figure();

/// A mesh that has the drawn levels on the slice through the middle of K, which has been subdivided.
struct ProofFigureMesh {
  Setting setting;
  Mesh mesh;
  Box k;
  Rational xi;
  int margin;  ///< between the drawn squares and the domain's sides
};

/// Throws Rejected when the mesh is not such a one.
ProofFigureMesh proof_figure_mesh(const DrawnProofFigure& figure, const Setting& setting, const Mesh& mesh,
                                  const Box& k);

/// The drawn levels at every x alike, with the frame of p = (3, p2, p3) around the squares; admissible or not.
ProofFigureMesh make_proof_figure_mesh(const DrawnProofFigure& figure, int p2, int p3);

/// What the mesh has of a set, within the slice's drawn squares (patches) or seen along x (Sigma and regions).
DrawnSet found_set(const ProofFigureMesh& figure, const std::string& name);

/// Is the place in the set? Sigma and the regions are compared within the active region only.
bool comparable(const ProofFigureMesh& figure, const std::string& name, const std::array<Rational, 2>& place);
bool in_set(const DrawnSet& set, const std::array<Rational, 2>& place);

/// Do both sets have the same of the drawn squares' places at multiples of 1/4, or, for patches, the same half squares?
bool same_sets(const ProofFigureMesh& figure, const std::string& name, const DrawnSet& drawn);

}  // namespace asts::reference
