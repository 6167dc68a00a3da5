#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "properties/claims/claim.hpp"

namespace asts {

/// The two figures in the proof of Theorem 5.3, the yz-view on the slice S_x(xi) for m = 2 and level(K) = 3, in halves
/// of a unit: what is drawn on 17 x 21 unit squares.
struct ProofFigure {
  struct Rectangle {
    std::array<int, 2> lower;
    std::array<int, 2> upper;
  };

  std::array<Rectangle, 3> levels;  ///< where the level is at least 1, 2, 3
  Rectangle element;                ///< K, whose child is drawn with level 4
  Rectangle patch;                  ///< of K
  Rectangle second_patch;           ///< the second-order patch
  Rectangle sigma;                  ///< Sigma, a part of Rx
  Rectangle ring_outside;           ///< the other part of Rx: this
  Rectangle ring_inside;            ///< ... without the interior of this
  std::vector<Rectangle> lines_y;   ///< Ry: pieces of lines at one y
  std::vector<Rectangle> lines_z;   ///< Rz: at one z
  int around = 0;                   ///< units between the drawn squares and the active region's sides
};

/// As it is drawn. (The second figure's caption calls the lines of Ry horizontal and those of Rz vertical; in the
/// figure lines at one y are vertical, so the two words are exchanged. Here Ry has the lines at one y, as
/// Definition 5.1 says.)
ProofFigure drawn_proof_figure();

/// The same situation for p = (3,3,3), as Algorithm 2.9 makes it.
ProofFigure correct_proof_figure();

/// Bare subdivisions make the figure's levels, at every x alike, and subdivide one element K last. The active region
/// has the squares that are drawn and `around` more on each side; along x it is one unit, and K is at its lower end.
Case case_of_figure(const ProofFigure& figure, const PerAxis<int>& degree);

/// The element K, as a node of the refinement tree, of a mesh that has the drawn levels on the slice through K's
/// middle: the drawn squares in the middle of the domain, level 0 around them, the slice in the active region. Nothing
/// if the mesh is another one.
std::optional<std::int32_t> find_drawn_element(MeshUnderTest& mesh, const ProofFigure& figure);

/// What is drawn, item by item, and whether the mesh has it: the levels (is the mesh admissible?), the patch, the
/// second-order patch, Sigma, Rx, Ry, Rz. The perturbed regions and Sigma are compared within the active region.
using FigureItems = std::vector<std::pair<std::string, bool>>;
FigureItems items_of_figure(MeshUnderTest& mesh, std::int32_t element, const ProofFigure& figure);

/// For each drawn set the first place, in units of the drawn squares (y, z), that only one of figure and mesh has.
using FigureDifferences = std::vector<std::pair<std::string, std::optional<std::vector<Rational>>>>;
FigureDifferences differences_from_figure(MeshUnderTest& mesh, std::int32_t element, const ProofFigure& figure);

/// All items are there. Met: those that are.
Trial judge_proof_figure(MeshUnderTest& mesh, const ProofFigure& figure);

/// Some odd degrees p2, p3 >= 3 fit all items.
Trial judge_degrees(const ProofFigure& figure, int max_degree);

Trial figure_proof_levels(MeshUnderTest& mesh);
Trial figure_proof_levels_alone(Extent extent);
Trial figure_proof_levels_repaired(MeshUnderTest& mesh);
Trial figure_proof_levels_repaired_alone(Extent extent);

}  // namespace asts
