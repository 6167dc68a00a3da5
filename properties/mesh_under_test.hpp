#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "lib/mesh/mesh.hpp"
#include "lib/spline/bricks.hpp"
#include "lib/spline/dual_basis.hpp"
#include "lib/spline/perturbed_regions.hpp"
#include "lib/spline/tsplines.hpp"

namespace asts {

/// One mesh with all that its properties are decided from; splines and runs are built when first asked for.
class MeshUnderTest {
 public:
  /// The leaves of a tree. REQUIRES: the tree outlives it and does not change meanwhile; no leaf is marked.
  explicit MeshUnderTest(const RefinementTree& tree);
  /// An explicit mesh. Its refinement tree consists of the boxes that the class has and the elements above them.
  explicit MeshUnderTest(Mesh mesh);

  /// Pairs of bricks that may be looked at for one property; beyond it the verdict is undecided.
  std::size_t pair_budget = std::numeric_limits<std::size_t>::max();

  const Mesh& mesh() const { return mesh_; }
  const RefinementTree& tree() const { return *tree_; }
  /// An element that level-directed subdivisions of the initial mesh cannot make, if there is one.
  std::optional<std::int32_t> outside_class() const;
  /// Definition 3.2. Decided once.
  bool admissible();
  /// Nodes of the tree that are elements of the mesh or contain one: ids, ascending.
  std::vector<std::int32_t> tree_elements() const;

  const TSplines& splines();
  const Bricks& bricks();

  /// Decided once, for all that is asked about them. REQUIRES: all index vectors exist.
  const PerturbedRegions& perturbed_regions();          ///< Definition 5.1
  const std::optional<RegionsMeet>& meeting_regions();  ///< Definition 5.2: nothing when analysis-suitable
  const std::optional<NodePair>& incompatible();        ///< Definition 6.4: nothing when dual-compatible
  const DualBasisFailures& dual_failures();             ///< none when there is a dual basis (Definition 6.2)

  std::int64_t new_elements() const;
  /// The highest integer level of an element, if any has one.
  std::optional<std::int32_t> max_level() const;

 private:
  Mesh mesh_;
  const RefinementTree* tree_;
  std::unique_ptr<RecognisedTree> recognised_;
  std::optional<bool> admissible_;
  std::optional<TSplines> splines_;
  std::optional<Bricks> bricks_;
  std::optional<PerturbedRegions> perturbed_regions_;
  std::optional<std::optional<RegionsMeet>> meeting_regions_;
  std::optional<std::optional<NodePair>> incompatible_;
  std::optional<DualBasisFailures> dual_failures_;
};

}  // namespace asts
