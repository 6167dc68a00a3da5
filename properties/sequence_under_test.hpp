#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/refine/replay.hpp"
#include "lib/zones/zoned_mesh.hpp"
#include "properties/mesh_under_test.hpp"
#include "properties/properties.hpp"

namespace asts {

/// The meshes of a sequence of steps, one after the other: the same verdicts and witnesses as from MeshUnderTest for
/// each mesh, but what holds is proven zone by zone, and after a step only where the step changed something.
///
/// What is not proven is decided from the whole mesh, as is every witness: a property that is violated costs as much as
/// without all this.
///
/// Why a step can be enough: ZonedMesh for the properties of splines; stays_admissible; and nested patches follow from
/// nested windows along the axes (AxisGrid), which are few numbers.
class SequenceUnderTest {
 public:
  /// REQUIRES: the replay outlives it. So many threads are used; verdicts do not depend on them.
  explicit SequenceUnderTest(const Replay& replay, int jobs = 1, const ZoneLimits& limits = {})
      : replay_(replay), tree_(replay.tree()), jobs_(jobs), zones_(replay.tree(), limits) {}

  /// To be called after each step of the replay.
  void after_step();

  /// As decide(property, mesh()). Cost: where the property holds, linear in the elements the first time, later in what
  /// the steps since the last time changed; where it does not, that of the whole mesh.
  Verdict decide(const Property& property);
  /// The number of active nodes. Cost: as that of a property of splines.
  std::int64_t active_nodes();

  /// The mesh at hand in full, made when first asked for after a step. Cost: linear in the elements.
  MeshUnderTest& mesh();

  const RefinementTree& tree() const { return tree_; }
  /// Definition 3.2.
  bool admissible();
  /// The verdict on a property of splines, if it is proven of the mesh at hand.
  std::optional<Verdict> decide_proven(bool Proven::*property);

 private:
  const Proven& proven();

  const Replay& replay_;
  const RefinementTree& tree_;
  int jobs_;
  ZonedMesh zones_;
  std::optional<MeshUnderTest> mesh_;
  std::optional<Proven> proven_;            ///< of the mesh at hand
  std::vector<std::int32_t> since_proven_;  ///< subdivided since zones_ was asked, once it was
  bool zones_in_use_ = false;
  std::optional<bool> admissible_;  ///< of the mesh at hand
  bool was_admissible_ = false;     ///< the mesh before since_admissible_ was
  std::vector<std::int32_t> since_admissible_;
};

}  // namespace asts
