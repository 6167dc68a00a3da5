#include "lib/minimize/path_search.hpp"

#include <algorithm>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

CaseSize size_in(const PathCase& paths, std::int64_t subdivisions) {
  const Setting& setting = paths.setting;
  CaseSize size{false, subdivisions, static_cast<std::int64_t>(paths.steps.size()), 1, 0, setting.grading, 0};
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    size.volume *= setting.domain[axis];
    size.degree += setting.degree[axis];
  }
  for (const PathStep& step : paths.steps) {
    for (const ElementPath& mark : step.marks) size.depth = std::max<std::int64_t>(size.depth, level_of(mark) + 1);
  }
  return size;
}

}  // namespace

CaseSize size_of_mesh(const PathCase& mesh) {
  std::int64_t subdivisions = 0;
  for (const PathStep& step : mesh.steps) subdivisions += static_cast<std::int64_t>(step.marks.size());
  return size_in(mesh, subdivisions);
}

PathSearch::PathSearch(Oracle& oracle, PathForm form, const PathCase& start) : oracle_(oracle), form_(form) {
  auto state = state_of(start);
  if (!state) throw ResourceError("the meshes of the sequence are too large");
  current_ = std::move(*state);
}

/// Nothing for a sequence whose meshes are too large to be followed.
std::optional<PathSearch::State> PathSearch::state_of(const PathCase& candidate) const try {
  State state;
  if (form_ == PathForm::mesh) {
    std::vector<ElementPath> subdivided = subdivided_of(candidate);
    state.paths = mesh_of_paths(candidate.setting, std::move(subdivided));
    state.size = size_of_mesh(state.paths);
  } else {
    FollowedPaths followed = follow_paths(case_of(candidate));
    state.paths = std::move(followed.paths);
    state.size = size_in(state.paths, followed.subdivisions);
  }
  state.written = case_of(state.paths);
  return state;
} catch (const ResourceError&) {
  return std::nullopt;
}

bool PathSearch::precedes_current(const State& state) const {
  if (state.size != current_.size) return state.size < current_.size;
  return compare_numbers(state.written, current_.written) < 0;
}

bool PathSearch::propose(const PathCase& candidate) {
  auto state = state_of(candidate);
  if (!state || !precedes_current(*state) || !oracle_.asks(state->written)) return false;
  current_ = std::move(*state);
  return true;
}

bool PathSearch::move_to(const PathCase& candidate) {
  auto state = state_of(candidate);
  if (!state || !oracle_.asks(state->written)) return false;
  current_ = std::move(*state);
  return true;
}

bool PathSearch::adopt(const PathSearch& other) {
  if (!precedes_current(other.current_)) return false;
  current_ = other.current_;
  return true;
}

}  // namespace asts
