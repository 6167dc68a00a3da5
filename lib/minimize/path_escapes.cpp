#include <algorithm>
#include <array>
#include <vector>

#include "lib/minimize/path_changes.hpp"
#include "lib/minimize/path_passes.hpp"

namespace asts {

namespace {

/// The domain with one layer more or less across each axis, at one of its sides, where its volume gets less.
constexpr std::array<std::array<int, 2>, 5> kChanges{{{0, 0}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}}};

std::optional<PathCase> resized(const PathCase& paths, const PerAxis<std::size_t>& changes) {
  PathCase result = paths;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto& [low, high] = kChanges[changes[at(axis)]];
    const int side = result.setting.domain[at(axis)];
    if (side + low + high < 1) return std::nullopt;
    if (high < 0) result = without_layers(result, axis, side - 1, 1);
    if (low < 0) result = without_layers(result, axis, 0, 1);
    if (high > 0) result = with_layers(result, axis, side, 1);
    if (low > 0) result = with_layers(result, axis, 0, 1);
  }
  return result;
}

}  // namespace

bool reshape_domain(PathSearch& search) {
  const PathCase from = search.current();
  PerAxis<std::size_t> changes{};
  for (changes[0] = 0; changes[0] < kChanges.size(); ++changes[0]) {
    for (changes[1] = 0; changes[1] < kChanges.size(); ++changes[1]) {
      for (changes[2] = 0; changes[2] < kChanges.size(); ++changes[2]) {
        const auto candidate = resized(from, changes);
        if (candidate && search.propose(*candidate)) return true;
      }
    }
  }
  return false;
}

namespace {

/// More unit cubes are not joined.
constexpr std::size_t kMostJoined = 4;

/// The case, and the case with everything one layer farther along an axis or back.
std::vector<PathCase> all_shifts(const PathCase& paths) {
  std::vector<PathCase> result{paths};
  for (Axis axis = 0; axis < kDimension; ++axis) {
    for (const int layers : {1, -1}) {
      if (auto candidate = shifted(paths, axis, layers)) result.push_back(std::move(*candidate));
    }
  }
  return result;
}

PathCase joined(const PathCase& mesh, const ElementPath& from, const ElementPath& to) {
  return map_paths(mesh, [&](ElementPath path) -> std::optional<ElementPath> {
    if (leads_to(from, path)) std::copy(to.begin(), to.end(), path.begin());
    return path;
  });
}

bool propose_shifted(PathSearch& search, const PathCase& candidate) {
  for (const PathCase& one : all_shifts(candidate)) {
    if (search.propose(one)) return true;
  }
  return false;
}

}  // namespace

bool join_cubes(PathSearch& search) {
  if (search.form() != PathForm::mesh || search.current().steps.empty()) return false;
  const std::vector<ElementPath> cubes = search.current().steps.front().marks;
  if (cubes.size() > kMostJoined) return false;
  for (const ElementPath& from : cubes) {
    for (const ElementPath& to : cubes) {
      if (from == to) continue;
      const PathCase candidate = joined(search.current(), from, to);
      if (propose_shifted(search, candidate)) return true;
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const int side = candidate.setting.domain[at(axis)];
        if (propose_shifted(search, with_layers(candidate, axis, side, 1))) return true;
      }
    }
  }
  return false;
}

bool turn_and_cut(PathSearch& search) {
  if (search.form() != PathForm::mesh) return false;
  constexpr int kMostLayers = 3;
  const PathCase from = search.current();
  const PathCase mirrored = with_children_mirrored(from);
  PerAxis<Axis> order{0, 1, 2};
  while (std::next_permutation(order.begin(), order.end())) {
    for (const PathCase* children : {&from, &mirrored}) {
      const PathCase turned = permuted(*children, order);
      const int m = turned.setting.grading;
      if (m > 2 && search.propose(with_grading(turned, m - 1, ChildMap::both_ends))) return true;
      const auto& domain = turned.setting.domain;
      const Axis longest = static_cast<Axis>(std::max_element(domain.begin(), domain.end()) - domain.begin());
      const int side = domain[at(longest)];
      for (int layers = 1; layers <= kMostLayers && layers < side; ++layers) {
        for (const int first : {side - layers, 0, 1, side / 2}) {
          if (first + layers > side) continue;
          if (search.propose(without_layers(turned, longest, first, layers))) return true;
        }
      }
    }
  }
  return false;
}

bool lower_levels(PathSearch& search) {
  if (search.form() != PathForm::mesh || search.current().steps.empty()) return false;
  const auto candidate = one_level_lower(search.current());
  return candidate && search.propose(*candidate);
}

bool lower_degree_inside(PathSearch& search) {
  const PathCase from = search.current();
  for (Axis axis = 0; axis < kDimension; ++axis) {
    PathCase lower = from;
    lower.setting.degree[at(axis)] -= 2;
    const int side = from.setting.domain[at(axis)];
    if (lower.setting.degree[at(axis)] < 3 || side < 3) continue;
    for (int high = side - 1; high > 0; --high) {
      for (int low = 0; low < high; ++low) {
        if (search.propose(without_layers(without_layers(lower, axis, high, 1), axis, low, 1))) return true;
      }
    }
  }
  return false;
}

std::span<const PathPass> escape_passes() {
  static constexpr std::array kPasses{PathPass{"lower-degree-inside", lower_degree_inside},
                                      PathPass{"lower-levels", lower_levels},
                                      PathPass{"refine-and-cut", refine_and_cut},
                                      PathPass{"clear-ends", clear_ends},
                                      PathPass{"grow-and-drop", grow_and_drop},
                                      PathPass{"drop-single-elements", drop_single_elements},
                                      PathPass{"reshape-domain", reshape_domain},
                                      PathPass{"join-cubes", join_cubes},
                                      PathPass{"join-layers", join_layers},
                                      PathPass{"turn-and-cut", turn_and_cut}};
  return kPasses;
}

}  // namespace asts
