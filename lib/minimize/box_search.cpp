#include "lib/minimize/box_search.hpp"

#include <algorithm>
#include <array>

#include "lib/minimize/box_changes.hpp"
#include "lib/minimize/drop_chunks.hpp"

namespace asts {

namespace {

bool drop_box_layers(BoxSearch& search) {
  bool any = false;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto layers = [&] { return static_cast<std::size_t>(search.current().domain[at(axis)]); };
    any |= drop_chunks(layers, [&](std::size_t first, std::size_t entries) {
      if (entries == layers()) return false;
      return search.propose(
          boxes_without_layers(search.current(), axis, static_cast<int>(first), static_cast<int>(entries)));
    });
  }
  return any;
}

/// Two neighbouring layers become one of half the thickness each.
bool compress_layers(BoxSearch& search) {
  bool any = false;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    for (int first = 0; first + 1 < search.current().domain[at(axis)];) {
      std::vector<Rational> to = coordinates_of(search.current(), axis);
      for (Rational& coordinate : to) {
        if (coordinate >= first + 2)
          coordinate -= 1;
        else if (coordinate > first)
          coordinate = first + (coordinate - first) / 2;
      }
      const bool compressed = search.propose(with_coordinates(search.current(), axis, to));
      any |= compressed;
      first += compressed ? 0 : 1;
    }
  }
  return any;
}

/// Coordinates strictly inside of the domain.
std::size_t inner_coordinates(const Case& boxes, Axis axis) { return coordinates_of(boxes, axis).size() - 2; }

/// A chunk of neighbouring coordinates falls onto the coordinate before or behind it.
bool collapse_coordinates(BoxSearch& search) {
  bool any = false;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    any |= drop_chunks([&] { return inner_coordinates(search.current(), axis); },
                       [&](std::size_t first, std::size_t entries) {
                         const std::vector<Rational> from = coordinates_of(search.current(), axis);
                         for (const std::size_t target : {first, first + entries + 1}) {
                           std::vector<Rational> to = from;
                           std::fill_n(to.begin() + static_cast<std::ptrdiff_t>(first) + 1, entries, from[target]);
                           if (search.propose(with_coordinates(search.current(), axis, to))) return true;
                         }
                         return false;
                       });
  }
  return any;
}

/// All faces at one coordinate.
bool drop_planes(BoxSearch& search) {
  bool any = false;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    for (const Rational& coordinate : coordinates_of(search.current(), axis)) {
      any |= search.propose(merged_at(search.current(), axis, coordinate));
    }
  }
  return any;
}

/// Pairs of boxes: through all layers of an extruded mesh first, then one by one.
bool merge_boxes(BoxSearch& search) {
  bool any = false;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    std::vector<std::optional<Axis>> directions;
    for (Axis along = 0; along < kDimension; ++along) {
      if (along != axis) directions.emplace_back(along);
    }
    directions.emplace_back(std::nullopt);
    for (const std::optional<Axis> along : directions) {
      for (std::size_t box = 0; box < search.current().elements.size(); ++box) {
        any |= search.propose(merged(search.current(), {axis, box, along}));
      }
    }
  }
  return any;
}

bool lower_box_degrees(BoxSearch& search) {
  bool any = false;
  for (std::size_t axes = (std::size_t{1} << kDimension) - 1; axes > 0; --axes) {
    for (const bool frame : {true, false}) {
      while (true) {
        Case candidate = search.current();
        bool possible = true;
        for (Axis axis = 0; axis < kDimension && possible; ++axis) {
          if ((axes >> axis & 1) == 0) continue;
          possible = candidate.degree[at(axis)] >= 5 && (!frame || candidate.domain[at(axis)] > 2);
          if (!possible) break;
          candidate.degree[at(axis)] -= 2;
          if (!frame) continue;
          candidate = boxes_without_layers(candidate, axis, candidate.domain[at(axis)] - 1, 1);
          candidate = boxes_without_layers(candidate, axis, 0, 1);
        }
        if (!possible || !search.propose(candidate)) break;
        any = true;
      }
    }
  }
  return any;
}

bool lower_box_grading(BoxSearch& search) {
  Case candidate = search.current();
  for (candidate.grading = 2; candidate.grading < std::min(search.current().grading, 8); ++candidate.grading) {
    if (search.propose(candidate)) return true;
  }
  return false;
}

bool turn_boxes(BoxSearch& search) {
  bool any = false;
  const Case from = search.current();
  PerAxis<Axis> order{0, 1, 2};
  do {
    for (std::size_t axes = 0; axes < std::size_t{1} << kDimension; ++axes) {
      PerAxis<bool> mirrored{};
      for (std::size_t axis = 0; axis < kDimension; ++axis) mirrored[axis] = (axes >> axis & 1) != 0;
      any |= search.propose(boxes_permuted(boxes_reflected(from, mirrored), order));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return any;
}

/// Fractions in place of the n coordinates inside of one unit interval: evenly spaced, or halved from one of its ends.
enum class Spacing { even, towards_lower, towards_upper };

Rational spaced(Spacing spacing, std::size_t i, std::size_t n) {
  if (spacing == Spacing::even) return Rational(i + 1) / Rational(n + 1);
  const std::size_t halvings = spacing == Spacing::towards_lower ? n - i : i + 1;
  const Rational part = Rational(1) / Rational(Integer(1) << halvings);
  return spacing == Spacing::towards_lower ? part : Rational(1 - part);
}

bool simplify_unit(BoxSearch& search, Axis axis, int unit) {
  const std::vector<Rational> from = coordinates_of(search.current(), axis);
  std::vector<std::size_t> inside;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] > unit && from[i] < unit + 1) inside.push_back(i);
  }
  for (const Spacing spacing : {Spacing::towards_lower, Spacing::towards_upper, Spacing::even}) {
    std::vector<Rational> to = from;
    for (std::size_t i = 0; i < inside.size(); ++i) to[inside[i]] = unit + spaced(spacing, i, inside.size());
    if (!inside.empty() && search.propose(with_coordinates(search.current(), axis, to))) return true;
  }
  return false;
}

/// A coordinate that is no integer becomes one of the two beside it, where that one is free.
bool snap_to_integers(BoxSearch& search, Axis axis) {
  bool any = false;
  for (std::size_t i = 1; i + 1 < coordinates_of(search.current(), axis).size(); ++i) {
    const std::vector<Rational> from = coordinates_of(search.current(), axis);
    const Integer below = numerator(from[i]) / denominator(from[i]);
    for (const Integer& integer : {below, Integer(below + 1)}) {
      if (denominator(from[i]) == 1 || from[i - 1] >= integer || from[i + 1] <= integer) continue;
      std::vector<Rational> to = from;
      to[i] = integer;
      any |= search.propose(with_coordinates(search.current(), axis, to));
      if (coordinates_of(search.current(), axis) != from) break;
    }
  }
  return any;
}

bool simplify_coordinates(BoxSearch& search) {
  bool any = false;
  for (Axis axis = 0; axis < kDimension; ++axis) any |= snap_to_integers(search, axis);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    for (int unit = 0; unit < search.current().domain[at(axis)]; ++unit) any |= simplify_unit(search, axis, unit);
  }
  return any;
}

}  // namespace

BoxSearch::BoxSearch(Oracle& oracle, const Case& start)
    : oracle_(oracle), current_(boxes_permuted(start, {0, 1, 2})), size_(size_of_boxes(current_)) {}

bool BoxSearch::propose(const Case& candidate) {
  const CaseSize size = size_of_boxes(candidate);
  const bool precedes = size != size_ ? size < size_ : compare_numbers(candidate, current_) < 0;
  if (!precedes || !oracle_.asks(candidate)) return false;
  current_ = candidate;
  size_ = size;
  return true;
}

std::span<const BoxPass> simplifying_passes() {
  static constexpr std::array kPasses{
      BoxPass{"drop-layers", drop_box_layers}, BoxPass{"collapse-coordinates", collapse_coordinates},
      BoxPass{"compress-layers", compress_layers}, BoxPass{"simplify-coordinates", simplify_coordinates}};
  return kPasses;
}

std::span<const BoxPass> merging_passes() {
  static constexpr std::array kPasses{BoxPass{"drop-planes", drop_planes}, BoxPass{"merge-boxes", merge_boxes},
                                      BoxPass{"lower-degrees", lower_box_degrees},
                                      BoxPass{"lower-grading", lower_box_grading}, BoxPass{"turn", turn_boxes}};
  return kPasses;
}

}  // namespace asts
