#include "lib/minimize/path_changes.hpp"

#include <algorithm>
#include <map>

namespace asts {

namespace {

constexpr std::int64_t kMostCubesOneLevelLower = 100'000;

std::int32_t mapped_child(std::int32_t child, int from, int to, ChildMap map) {
  const std::int32_t from_upper = from - 1 - child;
  switch (map) {
    case ChildMap::lower_end:
      return std::min(child, to - 1);
    case ChildMap::upper_end:
      return std::max(to - 1 - from_upper, 0);
    case ChildMap::both_ends:
      return child <= from_upper ? std::min(child, to - 1) : std::max(to - 1 - from_upper, 0);
    case ChildMap::in_scale:
      return static_cast<std::int32_t>(std::int64_t{child} * to / from);
  }
  return 0;
}

}  // namespace

PathCase map_paths(const PathCase& paths, const PathMap& map) {
  PathCase result{paths.setting, {}};
  for (const PathStep& step : paths.steps) {
    PathStep& changed = result.steps.emplace_back(PathStep{step.kind, {}});
    for (const ElementPath& mark : step.marks) {
      if (auto path = map(mark)) changed.marks.push_back(std::move(*path));
    }
  }
  return result;
}

std::vector<std::vector<ElementPath>> rows_along(const PathCase& mesh, Axis axis) {
  std::vector<std::vector<ElementPath>> rows;
  for (const PathStep& level : mesh.steps) {
    std::map<ElementPath, std::vector<ElementPath>> by_trace;
    for (const ElementPath& path : level.marks) {
      ElementPath trace = path;
      trace[at(axis)] = 0;
      by_trace[trace].push_back(path);
    }
    for (auto& [trace, row] : by_trace) rows.push_back(std::move(row));
  }
  return rows;
}

std::optional<Axis> extruded_along(const PathCase& mesh) {
  for (Axis axis = kDimension - 1; axis >= 0 && !mesh.steps.empty(); --axis) {
    const auto layers = static_cast<std::size_t>(mesh.setting.domain[at(axis)]);
    const auto rows = rows_along(mesh, axis);
    const bool all = std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return row.size() == layers; });
    if (all && layers > 1) return axis;
  }
  return std::nullopt;
}

std::vector<std::vector<ElementPath>> items_of(const PathCase& mesh) {
  if (const auto axis = extruded_along(mesh)) return rows_along(mesh, *axis);
  std::vector<std::vector<ElementPath>> items;
  for (const ElementPath& path : subdivided_of(mesh)) items.push_back({path});
  return items;
}

PathCase without_elements(const PathCase& paths, const std::vector<ElementPath>& dropped) {
  return map_paths(paths, [&](const ElementPath& path) -> std::optional<ElementPath> {
    const bool below = std::any_of(dropped.begin(), dropped.end(),
                                   [&](const ElementPath& ancestor) { return leads_to(ancestor, path); });
    if (below) return std::nullopt;
    return path;
  });
}

PathCase without_layers(const PathCase& paths, Axis axis, int first, int count) {
  PathCase result = map_paths(paths, [&](ElementPath path) -> std::optional<ElementPath> {
    std::int32_t& layer = path[at(axis)];
    if (layer >= first && layer < first + count) return std::nullopt;
    if (layer >= first) layer -= count;
    return path;
  });
  result.setting.domain[at(axis)] -= count;
  return result;
}

PathCase with_layers(const PathCase& paths, Axis axis, int first, int count) {
  PathCase result = map_paths(paths, [&](ElementPath path) -> std::optional<ElementPath> {
    if (path[at(axis)] >= first) path[at(axis)] += count;
    return path;
  });
  result.setting.domain[at(axis)] += count;
  return result;
}

std::optional<PathCase> shifted(const PathCase& paths, Axis axis, int layers) {
  bool inside = true;
  PathCase result = map_paths(paths, [&](ElementPath path) -> std::optional<ElementPath> {
    std::int32_t& layer = path[at(axis)];
    layer += layers;
    inside = inside && layer >= 0 && layer < paths.setting.domain[at(axis)];
    return path;
  });
  if (!inside) return std::nullopt;
  return result;
}

PathCase with_grading(const PathCase& paths, int grading, ChildMap map) {
  PathCase result = map_paths(paths, [&](ElementPath path) -> std::optional<ElementPath> {
    for (std::size_t i = kDimension; i < path.size(); ++i) {
      path[i] = mapped_child(path[i], paths.setting.grading, grading, map);
    }
    return path;
  });
  result.setting.grading = grading;
  return result;
}

PathCase reflected(const PathCase& paths, const PerAxis<bool>& axes) {
  const Setting& setting = paths.setting;
  return map_paths(paths, [&](ElementPath path) -> std::optional<ElementPath> {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const std::size_t axis = i % kDimension;
      if (!axes[axis]) continue;
      const int count = i < kDimension ? setting.domain[axis] : setting.grading;
      path[i] = count - 1 - path[i];
    }
    return path;
  });
}

PathCase permuted(const PathCase& paths, const PerAxis<Axis>& order) {
  PathCase result = map_paths(paths, [&](ElementPath path) -> std::optional<ElementPath> {
    const ElementPath old = path;
    for (std::size_t axis = 0; axis < kDimension; ++axis) path[axis] = old[at(order[axis])];
    return path;
  });
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    result.setting.domain[axis] = paths.setting.domain[at(order[axis])];
    result.setting.degree[axis] = paths.setting.degree[at(order[axis])];
  }
  return result;
}

std::optional<PathCase> one_level_lower(const PathCase& mesh) {
  PathCase result = permuted(mesh, {1, 2, 0});
  constexpr std::size_t kLast = kDimension - 1;
  // the layer that the lower end of each old one becomes
  std::vector<std::int32_t> layers(at(mesh.setting.domain[0]) + 1, 1);
  layers[0] = 0;
  for (const PathStep& step : mesh.steps) {
    for (const ElementPath& path : step.marks) layers[at(path[0]) + 1] = mesh.setting.grading;
  }
  std::int64_t cubes = 1;
  for (std::size_t axis = 0; axis < kLast; ++axis) cubes *= result.setting.domain[axis];
  for (std::size_t i = 1; i < layers.size(); ++i) {
    layers[i] += layers[i - 1];
    if (cubes * layers[i] > kMostCubesOneLevelLower) return std::nullopt;
  }
  result = map_paths(result, [&](ElementPath path) -> std::optional<ElementPath> {
    if (level_of(path) == 0) return std::nullopt;
    path[kLast] = layers[at(path[kLast])] + path[kDimension];
    path.erase(path.begin() + kDimension);
    return path;
  });
  result.setting.domain[kLast] = layers.back();
  return result;
}

PathCase with_children_mirrored(const PathCase& paths) {
  return map_paths(paths, [m = paths.setting.grading](ElementPath path) -> std::optional<ElementPath> {
    for (std::size_t i = kDimension; i < path.size(); ++i) path[i] = m - 1 - path[i];
    return path;
  });
}

}  // namespace asts
