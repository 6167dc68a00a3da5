#include "fuzz/targets/case_mutator.hpp"

#include <algorithm>

#include "lib/mesh/mesh.hpp"
#include "lib/refine/replay.hpp"

namespace asts::fuzz {

namespace {

/// A domain that became shorter: marks move to its new face.
void keep_marks_inside(Case& content) {
  for (Step& step : content.steps) {
    for (Point& mark : step.marks) {
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        if (mark[axis].value() > content.domain[axis]) mark[axis] = CompactRational(content.domain[axis]);
      }
    }
  }
}

}  // namespace

std::optional<Case> with_other_setting(const Case& content, Draw& draw) {
  Case result = content;
  const std::size_t axis = draw.index(kDimension);
  switch (draw.between(0, 3)) {
    case 0:
      result.grading = draw.between(2, 4);
      break;
    case 1:
      result.degree[axis] = content.degree[axis] == 3 ? 5 : 3;
      break;
    default:
      if (content.explicit_mesh) return std::nullopt;
      result.domain[axis] = std::max(1, content.domain[axis] + (draw.one_in(2) ? 1 : -1));
      keep_marks_inside(result);
  }
  return result;
}

Case written_out(const Case& content) {
  Replay replay(content);
  while (!replay.done()) replay.advance();
  const Mesh mesh = mesh_of(replay.tree());
  Case result = content;
  result.steps.clear();
  result.explicit_mesh = true;
  for (const Box& box : mesh.elements) {
    ElementLine line;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      line.lower[at(axis)] = CompactRational(mesh.coordinate(axis, box.lower[at(axis)]));
      line.upper[at(axis)] = CompactRational(mesh.coordinate(axis, box.upper[at(axis)]));
    }
    result.elements.push_back(line);
  }
  return result;
}

std::optional<Case> mutated(const Case& content, Draw& draw) {
  if (draw.one_in(8)) return with_other_setting(content, draw);
  if (content.explicit_mesh) return with_other_boxes(content, draw);
  if (draw.one_in(50)) return written_out(content);
  return with_other_steps(content, draw);
}

}  // namespace asts::fuzz
