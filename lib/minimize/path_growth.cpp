#include <array>
#include <vector>

#include "lib/minimize/path_changes.hpp"
#include "lib/minimize/path_passes.hpp"

namespace asts {

namespace {

std::vector<PathCase> with_higher_gradings(const PathCase& paths) {
  std::vector<PathCase> result;
  const int m = paths.setting.grading;
  for (const int larger : {m + 1, 2 * m}) {
    for (const ChildMap map : {ChildMap::lower_end, ChildMap::upper_end}) {
      if (larger <= kMaxGrading) result.push_back(with_grading(paths, larger, map));
    }
  }
  return result;
}

/// Settings next to the current one that are larger.
std::vector<PathCase> grown(const PathCase& paths) {
  std::vector<PathCase> result;
  const auto extruded = extruded_along(paths);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    if (axis == extruded) continue;  // a new layer would be empty
    const int side = paths.setting.domain[at(axis)];
    for (const int layers : {1, 2}) {
      for (int place = 0; place <= side; ++place) result.push_back(with_layers(paths, axis, place, layers));
    }
    PathCase higher = with_layers(with_layers(paths, axis, side, 1), axis, 0, 1);
    higher.setting.degree[at(axis)] += 2;
    result.push_back(std::move(higher));
  }
  for (const PathCase& finer : with_higher_gradings(paths)) result.push_back(finer);
  return result;
}

/// So few items are left out of every larger setting one by one; more of them only where the larger setting itself
/// violates.
constexpr std::size_t kFew = 4;
constexpr std::size_t kFewRows = 8;

/// Steps of a sequence, items of a mesh.
bool propose_without_each(PathSearch& search, const PathCase& larger) {
  if (search.form() == PathForm::sequence) {
    for (std::size_t step = 0; step < larger.steps.size(); ++step) {
      PathCase candidate = larger;
      candidate.steps.erase(candidate.steps.begin() + static_cast<std::ptrdiff_t>(step));
      if (search.propose(candidate) || search.propose(with_children_mirrored(candidate))) return true;
    }
    return false;
  }
  for (const std::vector<ElementPath>& item : items_of(larger)) {
    if (search.propose(without_elements(larger, item))) return true;
  }
  return false;
}

bool descend_from(PathSearch& search, const PathCase& larger) {
  PathSearch other = search;
  if (!other.move_to(larger) || !drop_elements(other)) return false;
  if (other.size().subdivisions >= search.size().subdivisions) return false;
  descend(other);
  return search.adopt(other);
}

}  // namespace

bool grow_and_drop(PathSearch& search) {
  if (subdivided_of(search.current()).size() > kMostMoved) return false;
  const bool mesh = search.form() == PathForm::mesh;
  const std::size_t items = mesh ? items_of(search.current()).size() : search.current().steps.size();
  const bool rows = mesh && extruded_along(search.current());
  const bool few = items <= (rows ? kFewRows : kFew);
  for (const PathCase& larger : grown(search.current())) {
    if (few ? propose_without_each(search, larger) : descend_from(search, larger)) return true;
  }
  return false;
}

bool clear_ends(PathSearch& search) {
  if (search.form() != PathForm::mesh) return false;
  constexpr int kMostCleared = 3;
  constexpr int kMostAdded = 3;
  const PathCase from = search.current();
  const auto extruded = extruded_along(from);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const int side = from.setting.domain[at(axis)];
    for (int cleared = 1; axis != extruded && cleared <= kMostCleared && cleared < side; ++cleared) {
      for (int empty = cleared; empty <= cleared + kMostAdded; ++empty) {
        const PathCase low = with_layers(without_layers(from, axis, 0, cleared), axis, 0, empty);
        const PathCase high =
            with_layers(without_layers(from, axis, side - cleared, cleared), axis, side - cleared, empty);
        if (search.propose(low) || search.propose(high)) return true;
      }
    }
  }
  return false;
}

bool refine_and_cut(PathSearch& search) {
  if (subdivided_of(search.current()).size() > kMostMoved) return false;
  for (const PathCase& finer : with_higher_gradings(search.current())) {
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const int side = finer.setting.domain[at(axis)];
      for (int layer = 0; layer < side && side > 1; ++layer) {
        if (search.propose(without_layers(finer, axis, layer, 1))) return true;
      }
    }
  }
  return false;
}

bool join_layers(PathSearch& search) {
  if (search.form() != PathForm::mesh || items_of(search.current()).size() > kFewRows) return false;
  const PathCase from = search.current();
  const auto extruded = extruded_along(from);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    for (int layer = 0; axis != extruded && layer + 1 < from.setting.domain[at(axis)]; ++layer) {
      for (const int target : {layer, layer + 1}) {
        const PathCase joined_layers = map_paths(from, [&](ElementPath path) -> std::optional<ElementPath> {
          if (path[at(axis)] == layer || path[at(axis)] == layer + 1) path[at(axis)] = target;
          return path;
        });
        const PathCase folded = mesh_of_paths(from.setting, subdivided_of(joined_layers));
        if (subdivided_of(folded).size() == subdivided_of(from).size()) continue;  // one of the layers is empty
        if (search.propose(folded) || propose_without_each(search, folded)) return true;
      }
    }
  }
  return false;
}

}  // namespace asts
