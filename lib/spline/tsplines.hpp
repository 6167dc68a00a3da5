#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/spline/active_region.hpp"
#include "lib/spline/index_vectors.hpp"

namespace asts {

/// The active nodes of a mesh (Definition 4.1) with their local index vectors (Definition 4.4), which determine the
/// blending functions B_v (Definition 4.5). Nodes are numbered in the lexicographic order of their coordinates.
struct TSplines {
  /// Where an index vector does not exist: the global index set has too few entries on one side of the node. That
  /// happens only on explicit meshes: a refinement of the initial mesh has all integers in every global index set.
  struct MissingVector {
    PerAxis<std::int32_t> node;
    Axis axis;
  };

  ActiveRegion region;
  std::vector<PerAxis<std::int32_t>> nodes;       ///< ranks
  std::vector<PerAxis<std::int32_t>> vector_ids;  ///< of each node, into `vectors`
  std::vector<IndexVectors> vectors;              ///< one an axis
  /// For each axis the nodes in the order of the lines parallel to it: nodes of one line stand together, ascending.
  PerAxis<std::vector<std::int32_t>> line_order;
  std::optional<MissingVector> missing;  ///< when set, `vector_ids` is incomplete

  std::int32_t size() const { return static_cast<std::int32_t>(nodes.size()); }
  std::span<const std::int32_t> index_vector(std::int32_t node, Axis axis) const {
    const auto a = at(axis);
    return vectors[a][vector_ids[at(node)][a]];
  }
  /// supp B_v along an axis: from the first to the last entry of the index vector, closed.
  RankInterval support(std::int32_t node, Axis axis) const {
    const auto a = at(axis);
    const std::int32_t id = vector_ids[at(node)][a];
    return {vectors[a].front(id), vectors[a].back(id)};
  }
};

/// Cost: linear in elements and active nodes, plus, where index vectors reach across elements without nodes on the
/// line, a search per entry; no scan of the mesh.
TSplines tsplines_of(const Mesh& mesh);

/// Whether subdividing an element K along an axis may change the active nodes or an index vector: whether an active
/// node v of the mesh G has its projection along the axis in that of K, both closed.
///
/// If not, they stay as they are. Say K = [x, x+x~] x R is subdivided along x. Xi_y and Xi_z stay, as sets of points,
/// and so do the index vectors along y and z; Xi_x gets the faces {xi} x R, which change X(v) only for v that project
/// into R. A new active node would be a vertex (xi, r) of such a face with x < xi < x+x~. The active region's ends are
/// integers and K lies between two successive ones, so that (x, r) is in it: an active node of G that projects into R.
/// REQUIRES: a refinement of the initial mesh by level-directed subdivisions. Cost: linear in the nodes.
bool may_change_splines(const TSplines& splines, const Box& element, Axis axis);

}  // namespace asts
