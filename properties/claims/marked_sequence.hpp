#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/mesh/case.hpp"
#include "lib/refine/replay.hpp"
#include "lib/refine/subdivided_elements.hpp"
#include "properties/witness.hpp"

namespace asts {

/// A sequence G_0, ..., G_J as in Theorem 7.1, with its marks.
struct MarkedSequence {
  struct Step {
    std::int64_t marked = 0;        ///< |M_j|, distinct elements
    std::int64_t subdivided = 0;    ///< elements of the closure
    std::int64_t new_elements = 0;  ///< |G_(j+1) \ G_0|
  };
  std::vector<Step> steps;
  std::vector<ElementInfo> marks;         ///< of all steps; distinct, a marked element is subdivided at once
  std::vector<ElementInfo> new_elements;  ///< G_J \ G_0, when asked for
};

/// The same where the meshes are too large to be built: the subdivided elements in place of the new ones.
struct NarrowSequence {
  std::vector<LevelCell> marks;
  SubdividedElements subdivided;
};

enum class NewElements { count, list };

/// Whether each step is a call of Algorithm 2.9, none a bare subdivision.
bool refines_only(const Case& sequence);

/// Replays the case. Nothing when a step is a bare subdivision.
std::optional<MarkedSequence> follow(const Case& sequence, NewElements wanted);

/// Whether every mesh of the case has at most so many elements. Replays it up to the first one that has more.
bool stays_below(const Case& sequence, std::int64_t elements);

/// REQUIRES: refines_only.
NarrowSequence follow_narrowly(const Case& sequence);

}  // namespace asts
