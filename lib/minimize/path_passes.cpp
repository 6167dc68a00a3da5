#include "lib/minimize/path_passes.hpp"

#include <algorithm>
#include <array>

#include "lib/mesh/reflection.hpp"
#include "lib/minimize/path_changes.hpp"

namespace asts {

namespace {

/// Degrees lower by 2 along some axes, with `low` and `high` layers less on their sides.
std::optional<PathCase> with_lower_degrees(const PathCase& paths, std::size_t axes, int low, int high) {
  PathCase result = paths;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    if ((axes >> axis & 1) == 0) continue;
    int& degree = result.setting.degree[at(axis)];
    const int side = result.setting.domain[at(axis)];
    if (degree < 5 || side <= low + high) return std::nullopt;
    degree -= 2;
    if (high > 0) result = without_layers(result, axis, side - high, high);
    if (low > 0) result = without_layers(result, axis, 0, low);
  }
  return result;
}

constexpr std::array kChildMaps{ChildMap::lower_end, ChildMap::upper_end, ChildMap::both_ends, ChildMap::in_scale};

bool propose_grading(PathSearch& search, int grading) {
  const PathCase from = search.current();
  for (const ChildMap map : kChildMaps) {
    PathCase candidate = with_grading(from, grading, map);
    if (search.propose(candidate)) return true;
    if (candidate.setting.degree == PerAxis<int>{3, 3, 3}) continue;
    candidate.setting.degree = {3, 3, 3};
    if (search.propose(candidate)) return true;
  }
  return false;
}

/// Elements with all below them elsewhere: entry `i` of their paths becomes `value`.
PathCase with_entry(const PathCase& paths, const std::vector<ElementPath>& elements, std::size_t i,
                    std::int32_t value) {
  return map_paths(paths, [&](ElementPath path) -> std::optional<ElementPath> {
    const bool moved = std::any_of(elements.begin(), elements.end(),
                                   [&](const ElementPath& element) { return leads_to(element, path); });
    if (moved) path[i] = value;
    return path;
  });
}

/// Smaller values for one entry, the smallest first.
bool lower_entry(PathSearch& search, std::vector<ElementPath>& elements, std::size_t i) {
  const std::int32_t value = elements.front()[i];
  for (const std::int32_t smaller : {0, value / 2, value - 1}) {
    if (smaller < 0 || smaller >= value) continue;
    if (!search.propose(with_entry(search.current(), elements, i, smaller))) continue;
    for (ElementPath& element : elements) element[i] = smaller;
    return true;
  }
  return false;
}

/// The marks of a sequence, one by one.
std::vector<std::vector<ElementPath>> marks_of(const PathCase& sequence) {
  std::vector<std::vector<ElementPath>> marks;
  for (const ElementPath& mark : subdivided_of(sequence)) marks.push_back({mark});
  return marks;
}

/// All unit cubes one layer lower, again and again.
bool shift(PathSearch& search, Axis axis) {
  bool any = false;
  while (!search.current().steps.empty()) {
    const auto candidate = shifted(search.current(), axis, -1);
    if (!candidate || !search.propose(*candidate)) break;
    any = true;
  }
  return any;
}

}  // namespace

bool lower_degrees(PathSearch& search) {
  bool any = false;
  for (std::size_t axes = (std::size_t{1} << kDimension) - 1; axes > 0; --axes) {
    for (const auto& [low, high] : {std::pair{1, 1}, std::pair{1, 0}, std::pair{0, 1}, std::pair{0, 0}}) {
      while (auto candidate = with_lower_degrees(search.current(), axes, low, high)) {
        if (!search.propose(*candidate)) break;
        any = true;
      }
    }
  }
  return any;
}

/// Small m one after the other; for a large m also by halving the range, since what fails for one m mostly fails for
/// those above it.
bool lower_grading(PathSearch& search) {
  constexpr int kTriedOneByOne = 6;
  const int start = search.current().setting.grading;
  for (int m = 2; m < start && m <= kTriedOneByOne; ++m) {
    if (propose_grading(search, m)) return true;
  }
  int fails = kTriedOneByOne;
  while (search.current().setting.grading - fails > 1) {
    const int middle = fails + (search.current().setting.grading - fails) / 2;
    if (!propose_grading(search, middle)) fails = middle;
  }
  return search.current().setting.grading < start;
}

bool permute_axes(PathSearch& search) {
  PerAxis<Axis> order{0, 1, 2};
  const PathCase from = search.current();
  bool any = false;
  while (std::next_permutation(order.begin(), order.end())) any |= search.propose(permuted(from, order));
  return any;
}

bool move_to_origin(PathSearch& search) {
  bool any = false;
  for (Axis axis = 0; axis < kDimension; ++axis) any |= shift(search, axis);
  const auto listed = [&] {
    return search.form() == PathForm::mesh ? items_of(search.current()) : marks_of(search.current());
  };
  const std::size_t count = listed().size();
  if (count > kMostMoved) return any;
  for (std::size_t i = 0; i < count && i < listed().size(); ++i) {
    std::vector<ElementPath> elements = listed()[i];
    const std::optional<Axis> layers =
        search.form() == PathForm::mesh ? extruded_along(search.current()) : std::nullopt;
    if (level_of(elements.front()) > 0) {
      any |= lower_entry(search, elements, elements.front().size() - 1);
      continue;
    }
    for (Axis axis = 0; axis < kDimension; ++axis) any |= axis != layers && lower_entry(search, elements, at(axis));
  }
  return any;
}

bool reflect_axes(PathSearch& search) {
  bool any = false;
  const PathCase from = search.current();
  for (const PerAxis<bool>& mirrored : reflections()) {
    const PathCase mirror_image = reflected(from, mirrored);
    any |= search.propose(mirror_image);
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const auto nearer = shifted(mirror_image, axis, -1);
      any |= nearer && search.propose(*nearer);
    }
  }
  return any;
}

bool merge_steps(PathSearch& search) {
  if (search.form() == PathForm::mesh || search.current().steps.size() > kMostMoved) return false;
  bool any = false;
  for (std::size_t step = 0; step + 1 < search.current().steps.size();) {
    PathCase merged = search.current();
    const PathStep& next = merged.steps[step + 1];
    bool accepted = false;
    if (merged.steps[step].kind == next.kind) {
      merged.steps[step].marks.insert(merged.steps[step].marks.end(), next.marks.begin(), next.marks.end());
      merged.steps.erase(merged.steps.begin() + static_cast<std::ptrdiff_t>(step) + 1);
      accepted = search.propose(merged);
    }
    any |= accepted;
    step += accepted ? 0 : 1;
  }
  return any;
}

bool write_out_closure(PathSearch& search) {
  if (search.form() == PathForm::mesh || search.size().subdivisions > 100'000) return false;
  const auto mesh = mesh_paths(search.written());
  return mesh && search.propose(*mesh);
}

std::span<const PathPass> descent_passes() {
  static constexpr std::array kPasses{
      PathPass{"drop-elements", drop_elements}, PathPass{"write-out-closure", write_out_closure},
      PathPass{"drop-layers", drop_layers},     PathPass{"drop-frame", drop_frame},
      PathPass{"lower-degrees", lower_degrees}, PathPass{"lower-grading", lower_grading},
      PathPass{"merge-steps", merge_steps},     PathPass{"permute-axes", permute_axes},
      PathPass{"reflect-axes", reflect_axes},   PathPass{"move-to-origin", move_to_origin}};
  return kPasses;
}

void descend(PathSearch& search) {
  bool any = true;
  while (any) {
    any = false;
    for (const PathPass& pass : descent_passes()) any |= pass.run(search);
  }
}

}  // namespace asts
