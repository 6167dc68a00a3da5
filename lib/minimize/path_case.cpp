#include "lib/minimize/path_case.hpp"

#include <algorithm>
#include <set>

#include "lib/exact/errors.hpp"
#include "lib/exact/rational.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/refine/replay.hpp"
#include "lib/refine/subdivided_elements.hpp"

namespace asts {

namespace {

/// A mesh with more elements is followed by the set of its subdivided elements.
constexpr std::int64_t kMostTreeElements = 1'000'000;

ElementPath path_of(const RefinementTree& tree, std::int32_t id) {
  std::vector<std::int32_t> children;
  while (tree.node(id).level > 0) {
    const std::int32_t parent = tree.node(id).parent;
    children.push_back(id - tree.node(parent).first_child);
    id = parent;
  }
  ElementPath path;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree.grid(axis);
    const Rational corner = grid.coordinate(grid.line_of_rank(tree.extent(id, axis).lower));
    path.push_back(static_cast<std::int32_t>(Integer(numerator(corner))));
  }
  path.insert(path.end(), children.rbegin(), children.rend());
  return path;
}

ElementPath path_of(const LevelCell& cell, int grading) {
  PerAxis<std::int64_t> index = cell.index;
  std::vector<std::int32_t> children;
  for (std::int32_t level = cell.level; level > 0; --level) {
    std::int64_t& along = index[at((level - 1) % kDimension)];
    children.push_back(static_cast<std::int32_t>(along % grading));
    along /= grading;
  }
  ElementPath path;
  for (const std::int64_t cube : index) path.push_back(static_cast<std::int32_t>(cube));
  path.insert(path.end(), children.rbegin(), children.rend());
  return path;
}

Point lower_corner(const ElementPath& path, int grading) {
  PerAxis<Rational> corner;
  PerAxis<Rational> size{1, 1, 1};
  for (Axis axis = 0; axis < kDimension; ++axis) corner[at(axis)] = path[at(axis)];
  for (std::int32_t level = 0; level < level_of(path); ++level) {
    const std::size_t axis = at(level % kDimension);
    size[axis] /= grading;
    corner[axis] += size[axis] * path[at(kDimension + level)];
  }
  Point point;
  for (std::size_t axis = 0; axis < kDimension; ++axis) point[axis] = CompactRational(corner[axis]);
  return point;
}

void sort_and_unite(std::vector<ElementPath>& paths) {
  std::sort(paths.begin(), paths.end());
  paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
}

std::optional<PathCase> paths_of_leaves(const RefinementTree& tree) {
  std::vector<ElementPath> subdivided;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.node(id).level >= 0 && !tree.is_leaf(id)) subdivided.push_back(path_of(tree, id));
  }
  return mesh_of_paths(tree.setting(), std::move(subdivided));
}

PathStep step_with(const Step& step, std::vector<ElementPath> marks) {
  sort_and_unite(marks);
  return {step.kind, std::move(marks)};
}

/// Nothing when a mesh has too many elements.
std::optional<FollowedPaths> follow_by_tree(const Case& test_case) {
  FollowedPaths result{{setting_of(test_case), {}}, 0};
  Replay replay(test_case);
  const std::int64_t initial = replay.tree().element_count();
  for (const Step& step : test_case.steps) {
    std::vector<ElementPath> marks;
    for (const Point& mark : step.marks) marks.push_back(path_of(replay.tree(), replay.tree().leaf_at(mark)));
    if (!marks.empty()) result.paths.steps.push_back(step_with(step, std::move(marks)));
    replay.advance();
    if (replay.tree().element_count() > kMostTreeElements) return std::nullopt;
  }
  result.subdivisions = (replay.tree().element_count() - initial) / (test_case.grading - 1);
  return result;
}

FollowedPaths follow_by_set(const Case& test_case) {
  FollowedPaths result{{setting_of(test_case), {}}, 0};
  SubdividedElements subdivided(setting_of(test_case));
  for (const Step& step : test_case.steps) {
    if (step.kind != Step::Kind::refine) throw ResourceError("a mesh of bare subdivisions has too many elements");
    std::vector<LevelCell> cells;
    std::vector<ElementPath> marks;
    for (const Point& mark : step.marks) {
      cells.push_back(subdivided.element_at(mark));
      marks.push_back(path_of(cells.back(), test_case.grading));
    }
    if (!marks.empty()) result.paths.steps.push_back(step_with(step, std::move(marks)));
    subdivided.refine(cells);
  }
  result.subdivisions = static_cast<std::int64_t>(subdivided.elements().size());
  return result;
}

}  // namespace

bool leads_to(const ElementPath& ancestor, const ElementPath& element) {
  return ancestor.size() <= element.size() && std::equal(ancestor.begin(), ancestor.end(), element.begin());
}

std::optional<PathCase> mesh_paths(const Case& test_case) {
  if (test_case.explicit_mesh) {
    const RecognisedTree recognised = recognise(mesh_of(setting_of(test_case), test_case.elements));
    if (!recognised.complete()) return std::nullopt;
    return paths_of_leaves(recognised.tree);
  }
  Replay replay(test_case);
  while (!replay.done()) replay.advance();
  return paths_of_leaves(replay.tree());
}

FollowedPaths follow_paths(const Case& test_case) {
  require(!test_case.explicit_mesh, "an explicit mesh has no steps");
  if (auto followed = follow_by_tree(test_case)) return std::move(*followed);
  return follow_by_set(test_case);
}

PathCase mesh_of_paths(const Setting& setting, std::vector<ElementPath> subdivided) {
  std::set<ElementPath> all;
  for (ElementPath& path : subdivided) {
    while (level_of(path) >= 0 && all.insert(path).second) path.pop_back();
  }
  PathCase result{setting, {}};
  for (const ElementPath& path : all) {
    const std::size_t level = at(level_of(path));
    if (result.steps.size() <= level) result.steps.resize(level + 1);
    result.steps[level].marks.push_back(path);
  }
  return result;
}

std::vector<ElementPath> subdivided_of(const PathCase& mesh) {
  std::vector<ElementPath> all;
  for (const PathStep& step : mesh.steps) all.insert(all.end(), step.marks.begin(), step.marks.end());
  return all;
}

Case case_of(const PathCase& paths) {
  const Setting& setting = paths.setting;
  Case result{setting.degree, setting.grading, setting.domain, {}, false, {}};
  for (const PathStep& step : paths.steps) {
    Step& written = result.steps.emplace_back(Step{step.kind, {}});
    for (const ElementPath& mark : step.marks) written.marks.push_back(lower_corner(mark, setting.grading));
  }
  return result;
}

}  // namespace asts
