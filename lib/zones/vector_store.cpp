#include "lib/zones/vector_store.hpp"

#include <algorithm>

namespace asts {

namespace {

constexpr std::int64_t kWidest = std::int64_t{1} << 62;

}  // namespace

/// Multiplies by m^levels; false when the result leaves 62 bits.
bool VectorStore::scale(std::int64_t& value, std::int32_t levels) const {
  for (; levels > 0 && value != 0; --levels) {
    if (__builtin_mul_overflow(value, std::int64_t{grading_}, &value)) return false;
    if (value >= kWidest || value <= -kWidest) return false;
  }
  return true;
}

VectorStore::Shape VectorStore::shape_of(const AxisGrid& grid, std::span<const std::int32_t> lines) {
  Shape shape;
  for (const std::int32_t line : lines) shape.depth = std::max(shape.depth, grid.line_depth(line));
  std::vector<std::int64_t> distances;
  for (const std::int32_t line : lines) {
    const auto index = grid.small_line_index(line);
    if (!index) return shape;
    std::int64_t place = *index;
    if (!scale(place, shape.depth - grid.line_depth(line))) return shape;
    if (distances.empty()) shape.first = place;
    distances.push_back(place - shape.first);
  }
  const auto [known, is_new] = known_.try_emplace(std::move(distances), static_cast<std::int32_t>(patterns_.size()));
  if (is_new) patterns_.push_back(&known->first);
  shape.pattern = known->second;
  return shape;
}

std::int32_t VectorStore::intern(const AxisGrid& grid, std::span<const std::int32_t> lines) {
  grading_ = grid.grading();
  const std::int32_t id = vectors_.intern(lines);
  if (at(id) == shapes_.size()) shapes_.push_back(shape_of(grid, lines));
  return id;
}

bool VectorStore::relate(std::int32_t x, std::int32_t x_tilde, Relation& result) const {
  const Shape& one = shapes_[at(x)];
  const Shape& other = shapes_[at(x_tilde)];
  if (one.pattern < 0 || other.pattern < 0) return false;
  std::int64_t first = one.first;
  std::int64_t second = other.first;
  const std::int32_t depths = other.depth - one.depth;
  if (!scale(first, depths) || !scale(second, -depths)) return false;
  result = {one.pattern, other.pattern, depths, second - first};
  return true;
}

}  // namespace asts
