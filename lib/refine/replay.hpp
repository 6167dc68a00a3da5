#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/mesh/case.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// What one step of a case did.
struct StepCounts {
  std::int64_t step = 0;        ///< 1 for the first one; 0 before it
  std::int64_t marked = 0;      ///< distinct elements that the marks name
  std::int64_t subdivided = 0;  ///< the closure of the marks for `refine`, the marks for `subdivide`
};

/// Replays the steps of a case, one after the other, from the initial mesh. Total: every sequence of valid steps is a
/// valid case.
class Replay {
 public:
  /// What it does and in which order does not depend on `jobs`, the number of threads.
  /// REQUIRES: `test_case` outlives it and is no explicit mesh; jobs >= 1. Throws what RefinementTree's constructor
  /// throws.
  explicit Replay(const Case& test_case, int jobs = 1);

  const RefinementTree& tree() const { return tree_; }
  const StepCounts& counts() const { return counts_; }
  /// The nodes that the last step subdivided, without repetition: for `refine` in mark_closure's order, for `subdivide`
  /// by rising identifiers. Empty before the first step.
  const std::vector<std::int32_t>& subdivided() const { return subdivided_; }
  bool done() const { return static_cast<std::size_t>(counts_.step) == case_.steps.size(); }

  /// Does the next step. REQUIRES: !done().
  void advance();

  /// Whether every step so far was an admissible subdivision (Definition 3.1): then the mesh is admissible by its
  /// history. The converse does not hold: another history may make the same mesh. Kept only when asked for.
  bool history_admissible() const { return history_admissible_; }
  void watch_history() { watch_history_ = true; }

 private:
  std::vector<std::int32_t> marked_leaves(const Step& step) const;

  const Case& case_;
  int jobs_;
  RefinementTree tree_;
  StepCounts counts_;
  std::vector<std::int32_t> subdivided_;
  bool watch_history_ = false;
  bool history_admissible_ = true;
};

/// The mesh behind all steps of a case, or its explicit mesh. Cost: that of the replay and of building the mesh.
/// Throws InputError when the case cannot be replayed, or its boxes do not tile the domain.
Mesh last_mesh(const Case& test_case);

}  // namespace asts
