#include "properties/claims/marked_sequence.hpp"

#include <algorithm>

#include "properties/describe.hpp"

namespace asts {

namespace {

void append_marks(const RefinementTree& tree, const Step& step, std::vector<ElementInfo>& marks) {
  std::vector<std::int32_t> leaves;
  for (const Point& mark : step.marks) leaves.push_back(tree.leaf_at(mark));
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  for (const std::int32_t leaf : leaves) marks.push_back(describe_tree_element(tree, leaf));
}

}  // namespace

bool refines_only(const Case& sequence) {
  return std::all_of(sequence.steps.begin(), sequence.steps.end(),
                     [](const Step& step) { return step.kind == Step::Kind::refine; });
}

std::optional<MarkedSequence> follow(const Case& sequence, NewElements wanted) {
  if (!refines_only(sequence)) return std::nullopt;
  MarkedSequence result;
  Replay replay(sequence);
  for (const Step& step : sequence.steps) {
    append_marks(replay.tree(), step, result.marks);
    replay.advance();
    result.steps.push_back({replay.counts().marked, replay.counts().subdivided, replay.tree().new_element_count()});
  }
  if (wanted == NewElements::count) return result;
  for (std::int32_t id = 0; id < replay.tree().node_count(); ++id) {
    if (!replay.tree().is_leaf(id) || replay.tree().node(id).level < 1) continue;
    result.new_elements.push_back(describe_tree_element(replay.tree(), id));
  }
  return result;
}

bool stays_below(const Case& sequence, std::int64_t elements) {
  Replay replay(sequence);
  while (!replay.done() && replay.tree().element_count() <= elements) replay.advance();
  return replay.tree().element_count() <= elements;
}

NarrowSequence follow_narrowly(const Case& sequence) {
  NarrowSequence result{{}, SubdividedElements(setting_of(sequence))};
  for (const Step& step : sequence.steps) {
    std::vector<LevelCell> marks;
    for (const Point& mark : step.marks) marks.push_back(result.subdivided.element_at(mark));
    std::sort(marks.begin(), marks.end());
    marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
    result.subdivided.refine(marks);
    result.marks.insert(result.marks.end(), marks.begin(), marks.end());
  }
  return result;
}

}  // namespace asts
