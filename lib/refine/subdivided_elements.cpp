#include "lib/refine/subdivided_elements.hpp"

#include <algorithm>

#include "lib/exact/errors.hpp"
#include "lib/mesh/level_formulas.hpp"

namespace asts {

namespace {

constexpr std::int64_t kMostCells = std::int64_t{1} << 61;

/// The axis along which an element of this level was split off its parent.
Axis split_from(std::int32_t level) { return (level - 1) % kDimension; }

/// A range of cells along each axis, both ends included.
struct CellRange {
  PerAxis<std::int64_t> first, last;
};

template <class Visit>
void for_each_cell(std::int32_t level, const CellRange& range, Visit visit) {
  LevelCell cell{level, range.first};
  for (cell.index[0] = range.first[0]; cell.index[0] <= range.last[0]; ++cell.index[0]) {
    for (cell.index[1] = range.first[1]; cell.index[1] <= range.last[1]; ++cell.index[1]) {
      for (cell.index[2] = range.first[2]; cell.index[2] <= range.last[2]; ++cell.index[2]) visit(cell);
    }
  }
}

}  // namespace

LevelCell child_of(const LevelCell& element, int grading, std::int64_t number) {
  LevelCell child{element.level + 1, element.index};
  std::int64_t& index = child.index[at(split_from(child.level))];
  index = index * grading + number;
  return child;
}

std::size_t SubdividedElements::Hash::operator()(const LevelCell& cell) const {
  std::uint64_t hash = static_cast<std::uint64_t>(cell.level);
  for (const std::int64_t index : cell.index) {
    hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 29U;
  }
  return hash;
}

std::int64_t SubdividedElements::new_element_count() const {
  return static_cast<std::int64_t>(order_.size()) * (setting_.grading - 1) + subdivided_cubes_;
}

std::int64_t SubdividedElements::cells_along(std::int32_t level, Axis axis) const {
  std::int64_t cells = setting_.domain[at(axis)];
  for (std::int32_t split = splits(level, axis); split > 0; --split) {
    if (cells >= kMostCells / setting_.grading) throw ResourceError("an axis has 2^61 cells of one level or more");
    cells *= setting_.grading;
  }
  return cells;
}

LevelCell SubdividedElements::parent(const LevelCell& cell) const {
  LevelCell result{cell.level - 1, cell.index};
  result.index[at(split_from(cell.level))] /= setting_.grading;
  return result;
}

LevelCell SubdividedElements::element_at(const Point& point) const {
  const auto cell_of_level = [&](std::int32_t level) {
    LevelCell cell{level, {}};
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const Rational scaled = point[at(axis)].value() * grading_power(setting_.grading, splits(level, axis));
      require(scaled >= 0 && scaled <= cells_along(level, axis), "the point is outside the domain");
      const auto index = static_cast<std::int64_t>(Integer(numerator(scaled) / denominator(scaled)));
      cell.index[at(axis)] = std::min(index, cells_along(level, axis) - 1);
    }
    return cell;
  };
  LevelCell cell = cell_of_level(0);
  while (contains(cell)) cell = cell_of_level(cell.level + 1);
  return cell;
}

/// REQUIRES: level >= 1.
/// U(K) reaches p+1 of K's sides beyond K, to either side, and is open; cells of K's own level that meet it are those
/// up to p+1 away. Along the axis that K was split off along, m of them are a cell of the next coarser level.
void SubdividedElements::add_coarser(const LevelCell& element, Set& marked, Cells& coarser) const {
  CellRange range{};
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::int64_t index = element.index[at(axis)];
    const std::int64_t reach = setting_.degree[at(axis)] + 1;
    range.first[at(axis)] = std::max<std::int64_t>(index - reach, 0);
    range.last[at(axis)] = std::min(index + reach, cells_along(element.level, axis) - 1);
  }
  const std::size_t split = at(split_from(element.level));
  range.first[split] /= setting_.grading;
  range.last[split] /= setting_.grading;
  for_each_cell(element.level - 1, range, [&](const LevelCell& cell) {
    ensure(is_there(cell), "Lemma 3.5: no element of a patch is coarser by more than a level");
    if (!contains(cell) && marked.insert(cell).second) coarser.push_back(cell);
  });
}

std::vector<LevelCell> SubdividedElements::refine(std::span<const LevelCell> marks) {
  std::vector<Cells> by_level;
  Set marked;
  for (const LevelCell& mark : marks) {
    require(is_there(mark) && !contains(mark), "a mark is no element of the mesh");
    if (by_level.size() <= at(mark.level)) by_level.resize(at(mark.level) + 1);
    if (marked.insert(mark).second) by_level[at(mark.level)].push_back(mark);
  }
  Cells closure;
  for (std::size_t level = by_level.size(); level-- > 0;) {
    const Cells& elements = by_level[level];
    for (const LevelCell& element : elements) {
      if (level > 0) add_coarser(element, marked, by_level[level - 1]);
      subdivided_cubes_ += level == 0;
    }
    closure.insert(closure.end(), elements.begin(), elements.end());
  }
  order_.insert(order_.end(), closure.begin(), closure.end());
  set_.insert(closure.begin(), closure.end());
  return closure;
}

}  // namespace asts
