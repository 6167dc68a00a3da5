#include <algorithm>
#include <functional>

#include "lib/minimize/drop_chunks.hpp"
#include "lib/minimize/path_changes.hpp"
#include "lib/minimize/path_passes.hpp"

namespace asts {

namespace {

bool drop_listed(PathSearch& search, std::vector<ElementPath> (*list)(const PathCase&)) {
  return drop_chunks([&] { return list(search.current()).size(); },
                     [&](std::size_t first, std::size_t entries) {
                       const std::vector<ElementPath> all = list(search.current());
                       const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
                       return search.propose(
                           without_elements(search.current(), {begin, begin + static_cast<std::ptrdiff_t>(entries)}));
                     });
}

std::vector<ElementPath> unit_cubes_of(const PathCase& mesh) {
  return mesh.steps.empty() ? std::vector<ElementPath>{} : mesh.steps.front().marks;
}

using Items = std::vector<std::vector<ElementPath>>;

/// Items of a list that is made anew after each removal.
bool drop_items(PathSearch& search, const std::function<Items(const PathCase&)>& list) {
  return drop_chunks([&] { return list(search.current()).size(); },
                     [&](std::size_t first, std::size_t entries) {
                       const Items items = list(search.current());
                       std::vector<ElementPath> dropped;
                       for (std::size_t i = first; i < first + entries; ++i) {
                         dropped.insert(dropped.end(), items[i].begin(), items[i].end());
                       }
                       return search.propose(without_elements(search.current(), dropped));
                     });
}

/// Rows along an axis that have more than one element.
bool drop_rows(PathSearch& search, Axis axis) {
  return drop_items(search, [axis](const PathCase& mesh) {
    Items rows = rows_along(mesh, axis);
    std::erase_if(rows, [](const auto& row) { return row.size() < 2; });
    return rows;
  });
}

PathCase without_steps(const PathCase& sequence, std::size_t first, std::size_t count) {
  PathCase result = sequence;
  const auto begin = result.steps.begin() + static_cast<std::ptrdiff_t>(first);
  result.steps.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  return result;
}

bool drop_steps(PathSearch& search) {
  return drop_chunks([&] { return search.current().steps.size(); },
                     [&](std::size_t first, std::size_t entries) {
                       return search.propose(without_steps(search.current(), first, entries));
                     });
}

/// Marks of steps that have more than one.
bool drop_marks(PathSearch& search) {
  bool any = false;
  for (std::size_t step = 0; step < search.current().steps.size(); ++step) {
    const auto count = [&] {
      if (step >= search.current().steps.size()) return std::size_t{0};
      return search.current().steps[step].marks.size();
    };
    if (count() < 2) continue;
    any |= drop_chunks(count, [&](std::size_t first, std::size_t entries) {
      PathCase candidate = search.current();
      std::vector<ElementPath>& marks = candidate.steps[step].marks;
      const auto begin = marks.begin() + static_cast<std::ptrdiff_t>(first);
      marks.erase(begin, begin + static_cast<std::ptrdiff_t>(entries));
      return search.propose(candidate);
    });
  }
  return any;
}

}  // namespace

bool drop_elements(PathSearch& search) {
  if (search.form() == PathForm::mesh) {
    if (extruded_along(search.current())) return drop_items(search, items_of);
    bool any = drop_listed(search, unit_cubes_of);
    for (Axis axis = 0; axis < kDimension; ++axis) any |= drop_rows(search, axis);
    return drop_listed(search, subdivided_of) || any;
  }
  const bool steps = drop_steps(search);
  return drop_marks(search) || steps;
}

bool drop_single_elements(PathSearch& search) {
  if (search.form() == PathForm::sequence || !extruded_along(search.current())) return false;
  return drop_listed(search, subdivided_of);
}

bool drop_layers(PathSearch& search) {
  bool any = false;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto layers = [&] { return static_cast<std::size_t>(search.current().setting.domain[at(axis)]); };
    any |= drop_chunks(layers, [&](std::size_t first, std::size_t entries) {
      if (entries == layers()) return false;
      return search.propose(without_layers(search.current(), axis, static_cast<int>(first), static_cast<int>(entries)));
    });
  }
  return any;
}

bool drop_frame(PathSearch& search) {
  bool any = false;
  for (std::size_t axes = (std::size_t{1} << kDimension) - 1; axes > 0; --axes) {
    PathCase candidate = search.current();
    bool possible = true;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      if ((axes >> axis & 1) == 0) continue;
      const int side = candidate.setting.domain[at(axis)];
      possible = possible && side > 2;
      if (possible) candidate = without_layers(without_layers(candidate, axis, side - 1, 1), axis, 0, 1);
    }
    any |= possible && search.propose(candidate);
  }
  return any;
}

}  // namespace asts
