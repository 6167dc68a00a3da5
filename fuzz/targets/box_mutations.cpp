#include <algorithm>

#include "fuzz/targets/case_mutator.hpp"

namespace asts::fuzz {

namespace {

/// Cuts a box at a half, third or quarter of its length.
Case split_box(const Case& content, Draw& draw) {
  Case result = content;
  const std::size_t place = draw.index(content.elements.size());
  const std::size_t axis = draw.index(kDimension);
  const int parts = draw.between(2, 4);
  ElementLine& box = result.elements[place];
  const Rational lower = box.lower[axis].value();
  const Rational cut = lower + (box.upper[axis].value() - lower) * draw.between(1, parts - 1) / parts;
  ElementLine rest = box;
  box.upper[axis] = rest.lower[axis] = CompactRational(cut);
  result.elements.push_back(rest);
  return result;
}

/// Whether `next` begins where `box` ends along the axis, with the same trace on the other axes.
bool continues(const ElementLine& box, const ElementLine& next, std::size_t axis) {
  for (std::size_t other = 0; other < kDimension; ++other) {
    if (other == axis) continue;
    if (box.lower[other] != next.lower[other] || box.upper[other] != next.upper[other]) return false;
  }
  return box.upper[axis] == next.lower[axis];
}

/// Joins a box with the one behind it, where they meet in a full face.
std::optional<Case> merge_boxes(const Case& content, Draw& draw) {
  const ElementLine& box = content.elements[draw.index(content.elements.size())];
  const std::size_t axis = draw.index(kDimension);
  const auto next = std::find_if(content.elements.begin(), content.elements.end(),
                                 [&](const ElementLine& other) { return continues(box, other, axis); });
  if (next == content.elements.end()) return std::nullopt;
  Case result = content;
  result.elements[static_cast<std::size_t>(&box - content.elements.data())].upper[axis] = next->upper[axis];
  result.elements.erase(result.elements.begin() + (next - content.elements.begin()));
  return result;
}

/// Moves the plane between two boxes that meet in a full face.
std::optional<Case> move_face(const Case& content, Draw& draw) {
  Case result = content;
  ElementLine& box = result.elements[draw.index(content.elements.size())];
  const std::size_t axis = draw.index(kDimension);
  const auto next = std::find_if(result.elements.begin(), result.elements.end(),
                                 [&](const ElementLine& other) { return continues(box, other, axis); });
  if (next == result.elements.end()) return std::nullopt;
  const int parts = draw.between(2, 4);
  const Rational lower = box.lower[axis].value();
  const Rational place = lower + (next->upper[axis].value() - lower) * draw.between(1, parts - 1) / parts;
  box.upper[axis] = next->lower[axis] = CompactRational(place);
  return result;
}

}  // namespace

std::optional<Case> with_other_boxes(const Case& content, Draw& draw) {
  switch (draw.between(0, 4)) {
    case 0:
    case 1:
      return split_box(content, draw);
    case 2:
    case 3:
      return merge_boxes(content, draw);
    default:
      return move_face(content, draw);
  }
}

}  // namespace asts::fuzz
