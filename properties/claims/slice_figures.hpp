#pragma once

#include <array>
#include <vector>

#include "properties/claims/claim.hpp"

namespace asts {

/// One of the two figures after Definition 5.2, read from its coordinates, which are written here in halves of a unit:
/// a grid of 4 x 5 unit squares with lines added, q = 3/2 and p = 3. The grid is the active region: frame and third
/// dimension, which the figures do not draw, are those of PlanarTiling::extruded.
struct SliceFigure {
  struct Line {
    std::size_t axis;  ///< that the line is across: 0 for x = place, 1 for y = place
    int place;
    int begin;
    int end;
  };
  using Node = std::array<int, 2>;
  struct Rectangle {
    Node lower;
    Node upper;
  };

  const char* name;
  std::vector<Line> lines;
  std::vector<Node> nodes_in;          ///< N_x(q)
  std::vector<Node> nodes_out;         ///< N_A without N_x(q)
  std::vector<Rectangle> support_in;   ///< the union of supp B_v, v in N_x(q), as far as it is drawn
  std::vector<Rectangle> support_out;  ///< the union of the others
  std::array<int, 2> perturbation;     ///< R_x(q): the y-range
  std::array<int, 2> extension;        ///< the classical T-junction extension at (3/2, 2): the y-range
  bool suitable;                       ///< what the caption says of the mesh
};

/// The first and the second figure.
std::vector<SliceFigure> slice_figures();

/// What is drawn is what the definitions give. Met: nodes and sets compared.
Trial judge_slice_figure(const SliceFigure& figure);

Trial figure_slices_alone(Extent extent);

}  // namespace asts
