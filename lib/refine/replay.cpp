#include "lib/refine/replay.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "lib/exact/errors.hpp"
#include "lib/refine/admissibility.hpp"
#include "lib/refine/refinement.hpp"
#include "lib/threads/parallel_for.hpp"

namespace asts {

Replay::Replay(const Case& test_case, int jobs) : case_(test_case), jobs_(jobs), tree_(setting_of(test_case)) {
  require(jobs >= 1, "at least one job");
  require(!test_case.explicit_mesh, "an explicit mesh has no steps to replay");
}

/// The distinct leaves that the marks name, ascending.
std::vector<std::int32_t> Replay::marked_leaves(const Step& step) const {
  constexpr std::size_t kChunk = 4096;
  std::vector<std::int32_t> leaves(step.marks.size());
  parallel_for(jobs_, (leaves.size() + kChunk - 1) / kChunk, [&](std::size_t chunk, int) {
    const std::size_t end = std::min(leaves.size(), (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i) leaves[i] = tree_.leaf_at(step.marks[i]);
  });
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  return leaves;
}

void Replay::advance() {
  ensure(!done(), "no step is left");
  const Step& step = case_.steps[static_cast<std::size_t>(counts_.step)];
  std::vector<std::int32_t> leaves = marked_leaves(step);
  counts_.marked = static_cast<std::int64_t>(leaves.size());
  if (step.kind == Step::Kind::refine) leaves = mark_closure(tree_, leaves, jobs_);
  if (watch_history_ && history_admissible_) history_admissible_ = is_admissible_subdivision(tree_, leaves);
  subdivide_all(tree_, leaves, jobs_);
  counts_.subdivided = static_cast<std::int64_t>(leaves.size());
  subdivided_ = std::move(leaves);
  ++counts_.step;
}

Mesh last_mesh(const Case& test_case) {
  if (test_case.explicit_mesh) return mesh_of(setting_of(test_case), test_case.elements);
  Replay replay(test_case);
  while (!replay.done()) replay.advance();
  return mesh_of(replay.tree());
}

}  // namespace asts
