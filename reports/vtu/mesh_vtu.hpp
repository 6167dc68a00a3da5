#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/mesh_under_test.hpp"
#include "properties/verdict.hpp"
#include "reports/vtu/vtu_file.hpp"

namespace asts {

/// What a grid shows besides the mesh.
struct VtuChoice {
  /// A property or claim that was decided for the mesh.
  struct Decided {
    std::string id;
    Verdict verdict;
  };

  std::optional<std::int32_t> node;  ///< an active node by its number: its blending function is shown
  std::optional<Decided> decided;
  bool perturbed_regions = false;  ///< mark the elements that meet them; not applicable without active nodes
};

/// What `kind` says of a cell.
enum class VtuKind : std::uint8_t { element = 0, active_node = 1, witness_point = 2, sample = 3 };

struct VtuCounts {
  std::int64_t elements = 0;
  std::int64_t active_nodes = 0;
  std::int64_t witness_points = 0;
  std::int64_t samples = 0;                        ///< voxels of the lattice over the chosen support
  std::int64_t vertices = 0;                       ///< distinct vertices of elements; then come the other points
  std::int64_t points = 0;                         ///< all
  std::int64_t support_elements = 0;               ///< elements that share volume with the chosen support
  std::int64_t witness_elements = 0;               ///< elements that share volume with a box that the witness names
  std::optional<PerAxis<std::int64_t>> perturbed;  ///< elements that meet each perturbed region, when chosen

  std::int64_t cells() const { return elements + active_nodes + witness_points + samples; }
};

struct MeshVtu {
  VtuGrid grid;
  VtuCounts counts;
};

/// A mesh as an unstructured grid for ParaView, in index coordinates.
///
/// Cells, in this order; `kind` tells them apart, so that a threshold shows one sort alone:
/// 0. the elements, in the mesh's order, as voxels whose corners are shared points;
/// 1. the active nodes (Definition 4.1), in lexicographic order, as vertices;
/// 2. the points that a witness names, as vertices;
/// 3. with a chosen node, the voxels of a lattice over its support (BlendingSamples).
///
/// | cell data | |
/// |---|---|
/// | `kind` | as above |
/// | `level` | of an element (Definition 2.2); NaN where it is no integer, and for cells of other kinds |
/// | `support` | with a chosen node: 1 for elements that share volume with supp B_v, and for the lattice |
/// | `witness` | with a witness that names boxes: for an element the number, from 1, of the first box it overlaps |
/// | `perturbed_x`, ... | when chosen: 1 for the closed elements that meet R_x (Definition 5.1) |
///
/// | point data | |
/// |---|---|
/// | `node` | the active node's number in lexicographic order, -1 for other points |
/// | `vector_x`, ... | the number of its index vector along x (Definition 4.4): a row of `vectors_x`; else -1 |
/// | `value` | with a chosen node: B_v there |
/// | `witness` | with a witness that names nodes: the number, from 1, of the node or, behind all nodes, of the point |
///
/// | field data | |
/// |---|---|
/// | `degree`, `grading`, `domain`, `elements`, `active_nodes` | |
/// | `vectors_x`, ... | each index vector once: p+2 coordinates a row; missing when some vector does not exist |
/// | `chosen_node` | its coordinates |
/// | `statement`, `verdict`, `witness_kind` | words |
/// | `witness_boxes`, `witness_nodes`, `witness_points` | the names that the number `witness` counts |
///
/// What is rounded: coordinates and values of B_v, computed exactly, become float64 here, towards zero, for drawing
/// alone. In a deep mesh different points may then coincide and voxels have no volume. Which cells, points and
/// numbers there are, what shares a point, lies in a support or meets a region is decided exactly before.
///
/// REQUIRES: with `node`, all index vectors exist. Throws ResourceError when VTK's numbers do not suffice,
/// BudgetExhausted as MeshUnderTest::perturbed_regions(). Cost: linear in elements and nodes, that of the perturbed
/// regions if asked for, and for a chosen node O(p^2) operations a line that meets its support and one product a point
/// in it.
MeshVtu mesh_vtu(MeshUnderTest& mesh, const VtuChoice& choice);

}  // namespace asts
