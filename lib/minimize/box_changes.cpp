#include "lib/minimize/box_changes.hpp"

#include <algorithm>
#include <set>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

bool before(const ElementLine& a, const ElementLine& b) {
  for (const auto& [p, q] : {std::pair{&a.lower, &b.lower}, std::pair{&a.upper, &b.upper}}) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if ((*p)[axis] == (*q)[axis]) continue;
      return (*p)[axis].value() < (*q)[axis].value();
    }
  }
  return false;
}

Case sorted(Case boxes) {
  std::sort(boxes.elements.begin(), boxes.elements.end(), before);
  return boxes;
}

bool same_trace(const ElementLine& a, const ElementLine& b, Axis axis, std::optional<Axis> along) {
  for (Axis other = 0; other < kDimension; ++other) {
    if (other == axis || other == along) continue;
    if (a.lower[at(other)] != b.lower[at(other)] || a.upper[at(other)] != b.upper[at(other)]) return false;
  }
  return true;
}

/// Merges pairs across a coordinate whose lower box `chosen` accepts.
template <class Chosen>
Case merge_pairs(const Case& boxes, Axis axis, const CompactRational& coordinate, const Chosen& chosen) {
  Case result = boxes;
  result.elements.clear();
  std::vector<bool> gone(boxes.elements.size(), false);
  for (const ElementLine& lower : boxes.elements) {
    if (lower.upper[at(axis)] != coordinate || !chosen(lower)) {
      continue;
    }
    for (std::size_t i = 0; i < boxes.elements.size(); ++i) {
      const ElementLine& upper = boxes.elements[i];
      if (upper.lower[at(axis)] != coordinate || !same_trace(lower, upper, axis, std::nullopt)) continue;
      ElementLine both = lower;
      both.upper = upper.upper;
      result.elements.push_back(both);
      gone[i] = true;
      gone[static_cast<std::size_t>(&lower - boxes.elements.data())] = true;
    }
  }
  for (std::size_t i = 0; i < boxes.elements.size(); ++i) {
    if (!gone[i]) result.elements.push_back(boxes.elements[i]);
  }
  return sorted(std::move(result));
}

/// A box as an element of the class on the way down from its unit cube.
struct Descent {
  ElementPath path;
  PerAxis<Rational> lower;
  PerAxis<Rational> size;
};

bool in_one_box(const Case& boxes, const Descent& element) {
  return std::any_of(boxes.elements.begin(), boxes.elements.end(), [&](const ElementLine& box) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if (element.lower[axis] < box.lower[axis].value()) return false;
      if (element.lower[axis] + element.size[axis] > box.upper[axis].value()) return false;
    }
    return true;
  });
}

bool collect(const Case& boxes, const Descent& element, std::int32_t max_level, std::vector<ElementPath>& subdivided) {
  if (in_one_box(boxes, element)) return true;
  const std::int32_t level = level_of(element.path);
  if (level >= max_level) return false;
  subdivided.push_back(element.path);
  const std::size_t axis = at(level % kDimension);
  for (int child = 0; child < boxes.grading; ++child) {
    Descent next = element;
    next.path.push_back(child);
    next.size[axis] = element.size[axis] / boxes.grading;
    next.lower[axis] = element.lower[axis] + next.size[axis] * child;
    if (!collect(boxes, next, max_level, subdivided)) return false;
  }
  return true;
}

}  // namespace

std::vector<Rational> coordinates_of(const Case& boxes, Axis axis) {
  std::set<Rational> coordinates;
  for (const ElementLine& box : boxes.elements) {
    coordinates.insert(box.lower[at(axis)].value());
    coordinates.insert(box.upper[at(axis)].value());
  }
  return {coordinates.begin(), coordinates.end()};
}

Case with_coordinates(const Case& boxes, Axis axis, const std::vector<Rational>& to) {
  const std::vector<Rational> from = coordinates_of(boxes, axis);
  ensure(from.size() == to.size() && denominator(to.back()) == 1, "every coordinate has an image");
  const auto image = [&](const CompactRational& coordinate) {
    const auto found = std::lower_bound(from.begin(), from.end(), coordinate.value());
    return CompactRational(to[static_cast<std::size_t>(found - from.begin())]);
  };
  Case result = boxes;
  result.domain[at(axis)] = static_cast<int>(Integer(numerator(to.back())));
  result.elements.clear();
  for (ElementLine box : boxes.elements) {
    box.lower[at(axis)] = image(box.lower[at(axis)]);
    box.upper[at(axis)] = image(box.upper[at(axis)]);
    if (box.lower[at(axis)] != box.upper[at(axis)]) result.elements.push_back(box);
  }
  return sorted(std::move(result));
}

Case boxes_without_layers(const Case& boxes, Axis axis, int first, int count) {
  std::vector<Rational> to = coordinates_of(boxes, axis);
  for (Rational& coordinate : to) {
    if (coordinate > first) coordinate = std::max(Rational(first), Rational(coordinate - count));
  }
  return with_coordinates(boxes, axis, to);
}

Case merged(const Case& boxes, const Merge& merge) {
  const ElementLine& first = boxes.elements[merge.box];
  return merge_pairs(boxes, merge.axis, first.upper[at(merge.axis)],
                     [&](const ElementLine& lower) { return same_trace(lower, first, merge.axis, merge.along); });
}

Case merged_at(const Case& boxes, Axis axis, const Rational& coordinate) {
  return merge_pairs(boxes, axis, CompactRational(coordinate), [](const ElementLine&) { return true; });
}

Case boxes_reflected(const Case& boxes, const PerAxis<bool>& axes) {
  Case result = boxes;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (!axes[axis]) continue;
    for (ElementLine& box : result.elements) {
      const Rational lower = boxes.domain[axis] - box.upper[axis].value();
      box.upper[axis] = CompactRational(Rational(boxes.domain[axis] - box.lower[axis].value()));
      box.lower[axis] = CompactRational(lower);
    }
  }
  return sorted(std::move(result));
}

Case boxes_permuted(const Case& boxes, const PerAxis<Axis>& order) {
  Case result = boxes;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const std::size_t old = at(order[axis]);
    result.domain[axis] = boxes.domain[old];
    result.degree[axis] = boxes.degree[old];
    for (std::size_t i = 0; i < boxes.elements.size(); ++i) {
      result.elements[i].lower[axis] = boxes.elements[i].lower[old];
      result.elements[i].upper[axis] = boxes.elements[i].upper[old];
    }
  }
  return sorted(std::move(result));
}

std::optional<PathCase> refined_to_class(const Case& boxes, std::int32_t max_level) {
  std::vector<ElementPath> subdivided;
  PerAxis<std::int32_t> cube{};
  for (cube[0] = 0; cube[0] < boxes.domain[0]; ++cube[0]) {
    for (cube[1] = 0; cube[1] < boxes.domain[1]; ++cube[1]) {
      for (cube[2] = 0; cube[2] < boxes.domain[2]; ++cube[2]) {
        Descent start{{cube.begin(), cube.end()}, {cube[0], cube[1], cube[2]}, {1, 1, 1}};
        if (!collect(boxes, start, max_level, subdivided)) return std::nullopt;
      }
    }
  }
  return mesh_of_paths(setting_of(boxes), std::move(subdivided));
}

}  // namespace asts
