#include "lib/spline/slices.hpp"

#include <algorithm>

namespace asts {

namespace {

bool same_line(const PerAxis<std::int32_t>& one, const PerAxis<std::int32_t>& other, Axis axis) {
  for (Axis a = 0; a < kDimension; ++a) {
    if (a != axis && one[at(a)] != other[at(a)]) return false;
  }
  return true;
}

bool crosses_skeleton(const Mesh& mesh, Axis axis, const PerAxis<std::int32_t>& node, HalfRank q) {
  PerAxis<HalfRank> position;
  for (std::size_t a = 0; a < kDimension; ++a) position[a] = 2 * node[a];
  const std::vector<std::int32_t> entries = global_index_set(mesh, axis, position);
  return std::binary_search(entries.begin(), entries.end(), q / 2);
}

std::optional<Rectangle> support_in_slice(const TSplines& splines, Axis axis, HalfRank q, std::int32_t node) {
  Box box;
  for (Axis a = 0; a < kDimension; ++a) {
    const RankInterval support = splines.support(node, a);
    box.lower[at(a)] = std::max(2 * support.lower, splines.region.lower[at(a)]);
    box.upper[at(a)] = std::min(2 * support.upper, splines.region.upper[at(a)]);
    if (box.lower[at(a)] > box.upper[at(a)]) return std::nullopt;
  }
  if (q < box.lower[at(axis)] || q > box.upper[at(axis)]) return std::nullopt;
  return rectangle_of(axis, box);
}

}  // namespace

std::vector<bool> slice_nodes(const Mesh& mesh, const TSplines& splines, Axis axis, HalfRank q) {
  std::vector<bool> result(splines.nodes.size(), false);
  if (q % 2 != 0) return result;
  const PerAxis<std::int32_t>* previous = nullptr;
  bool belongs = false;
  for (const std::int32_t node : splines.line_order[at(axis)]) {
    const PerAxis<std::int32_t>& place = splines.nodes[at(node)];
    if (previous == nullptr || !same_line(*previous, place, axis)) belongs = crosses_skeleton(mesh, axis, place, q);
    previous = &place;
    result[at(node)] = belongs;
  }
  return result;
}

std::vector<Rectangle> supports_in_slice(const TSplines& splines, Axis axis, HalfRank q,
                                         std::span<const std::int32_t> nodes) {
  std::vector<Rectangle> result;
  for (const std::int32_t node : nodes) {
    if (const auto rectangle = support_in_slice(splines, axis, q, node)) result.push_back(*rectangle);
  }
  return result;
}

Box box_in_slice(Axis axis, HalfRank q, const Rectangle& rectangle) {
  Box box;
  std::size_t side = 0;
  for (Axis other = 0; other < kDimension; ++other) {
    box.lower[at(other)] = other == axis ? q : rectangle.lower[side];
    box.upper[at(other)] = other == axis ? q : rectangle.upper[side];
    if (other != axis) ++side;
  }
  return box;
}

Rectangle rectangle_of(Axis axis, const Box& box) {
  Rectangle rectangle{};
  std::size_t side = 0;
  for (Axis other = 0; other < kDimension; ++other) {
    if (other == axis) continue;
    rectangle.lower[side] = box.lower[at(other)];
    rectangle.upper[side] = box.upper[at(other)];
    ++side;
  }
  return rectangle;
}

}  // namespace asts
