#include "lib/refine/replay.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "lib/exact/errors.hpp"
#include "lib/refine/admissibility.hpp"
#include "lib/refine/refinement.hpp"

namespace asts {

Replay::Replay(const Case& test_case) : case_(test_case), tree_(setting_of(test_case)) {
  require(!test_case.explicit_mesh, "an explicit mesh has no steps to replay");
}

void Replay::advance() {
  ensure(!done(), "no step is left");
  const Step& step = case_.steps[static_cast<std::size_t>(counts_.step)];
  std::vector<std::int32_t> leaves;
  leaves.reserve(step.marks.size());
  for (const Point& mark : step.marks) leaves.push_back(tree_.leaf_at(mark));
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  counts_.marked = static_cast<std::int64_t>(leaves.size());
  if (step.kind == Step::Kind::refine) leaves = mark_closure(tree_, leaves);
  if (watch_history_ && history_admissible_) history_admissible_ = is_admissible_subdivision(tree_, leaves);
  subdivide_all(tree_, leaves);
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
