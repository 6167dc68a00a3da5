#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "lib/mesh/locator.hpp"
#include "lib/mesh/refinement_tree.hpp"
#include "lib/mesh/setting.hpp"

namespace asts {

/// A closed box between mesh lines, by the ranks of the lines on their axes. Lines are ordered, so that everything
/// that depends on order alone (skeletons, index vectors, overlap, perturbed regions) is decided on ranks, exactly and
/// at any depth.
struct Box {
  PerAxis<std::int32_t> lower;
  PerAxis<std::int32_t> upper;

  friend bool operator==(const Box&, const Box&) = default;
};

/// A mesh: a set of closed boxes ("elements") that tile the domain. It comes from a refinement tree or from explicit
/// boxes, which need not be a refinement of the initial mesh.
struct Mesh {
  static constexpr std::int32_t kNoLevel = std::numeric_limits<std::int32_t>::min();

  Setting setting;
  PerAxis<std::vector<Rational>> coordinates;  ///< the lines in use, ascending; the index is the line's rank
  std::vector<Box> elements;
  std::vector<std::int32_t> levels;  ///< Definition 2.2; kNoLevel where -log_m of the volume is no integer
  Locator locator;                   ///< finds the element that covers a cell between neighbouring lines

  const Rational& coordinate(Axis axis, std::int32_t rank) const { return coordinates[at(axis)][at(rank)]; }
};

/// The leaves of a refinement tree, in the tree's order. Cost: linear in the tree's nodes.
/// REQUIRES: ranks are up to date.
Mesh mesh_of(const RefinementTree& tree);

/// The mesh of explicit boxes, in the order of the lines. Throws InputError "LINE: reason" when boxes overlap or leave
/// a gap, naming the line of a box at fault. Cost: O(n log n) for n boxes of a mesh that hierarchical cuts can make.
/// REQUIRES: the boxes are not empty and lie in the domain (parse_case sees to it).
Mesh mesh_of(const Setting& setting, const std::vector<ElementLine>& elements);

/// The refinement tree of those boxes that level-directed subdivisions of the initial mesh can make.
struct RecognisedTree {
  RefinementTree tree;
  std::vector<std::int32_t> node_of_element;  ///< the tree's node for each element; kNone for a box outside the class
  bool complete() const;                      ///< no box is outside the class: the leaves of the tree are the mesh
};

/// Finds, for each element of an explicit mesh, whether the class of Definition 2.6 has it, and the tree that contains
/// these. Cost: linear in elements times depth.
RecognisedTree recognise(const Mesh& mesh);

}  // namespace asts
