#include "lib/mesh/axis_grid.hpp"

#include <limits>

#include "lib/exact/errors.hpp"

namespace asts {

AxisGrid::AxisGrid(int length, int grading, int degree) : grading_(grading), degree_(degree) {
  require(length >= 1 && grading >= 2 && degree >= 1, "an axis needs length >= 1, grading >= 2, degree >= 1");
  lines_.reserve(at(length) + 1);
  for (int i = 0; i <= length; ++i) lines_.push_back(GridCoordinate(grading, i, 0));
  unit_cells_.assign(at(length), kNone);
  build_blocks();
  for (const std::int32_t cell : unit_cells_) {
    cells_[at(cell)].window_lower_line = window_line(cell, -1);
    cells_[at(cell)].window_upper_line = window_line(cell, +1);
  }
  update_ranks();
}

std::int32_t AxisGrid::add_cell(std::int32_t parent, std::int32_t lower_line, std::int32_t upper_line,
                                std::int32_t depth) {
  if (cells_.size() >= at(std::numeric_limits<std::int32_t>::max())) throw ResourceError("too many cells on an axis");
  cells_.push_back({parent, kNone, lower_line, upper_line, kNone, kNone, depth, 1});
  ranks_stale_ = true;
  return static_cast<std::int32_t>(cells_.size() - 1);
}

/// The binary hierarchy above the unit cells: each block is halved until single unit cells are left.
void AxisGrid::build_blocks() {
  const auto add_block = [this](std::int32_t parent, std::int32_t first, std::int32_t count) {
    const std::int32_t cell = add_cell(parent, first, first + count, count == 1 ? 0 : -1);
    cells_[at(cell)].units = count;
    if (count == 1) unit_cells_[at(first)] = cell;
  };
  add_block(kNone, 0, length());
  for (std::int32_t cell = 0; cell < static_cast<std::int32_t>(cells_.size()); ++cell) {
    if (!is_block(cell)) continue;
    const std::int32_t first = cells_[at(cell)].lower_line;
    const std::int32_t count = cells_[at(cell)].units;
    cells_[at(cell)].first_child = static_cast<std::int32_t>(cells_.size());
    add_block(cell, first, (count + 1) / 2);
    add_block(cell, first + (count + 1) / 2, count / 2);
  }
}

void AxisGrid::split(std::int32_t cell) {
  const Cell parent = cells_[at(cell)];
  if (parent.first_child != kNone) return;
  cells_[at(cell)].first_child = static_cast<std::int32_t>(cells_.size());
  const GridCoordinate start = lines_[at(parent.lower_line)].at_depth(parent.depth);
  std::int32_t lower = parent.lower_line;
  for (int j = 1; j <= grading_; ++j) {
    std::int32_t upper = parent.upper_line;
    if (j < grading_) {
      upper = line_count();
      lines_.push_back(start.refined(j));
    }
    add_cell(cell, lower, upper, parent.depth + 1);
    lower = upper;
  }
}

std::int32_t AxisGrid::children(std::int32_t cell) {
  if (has_children(cell)) return cells_[at(cell)].first_child;
  split(cell);
  const std::int32_t first = cells_[at(cell)].first_child;
  for (std::int32_t child = first; child < first + grading_; ++child) {
    const std::int32_t lower = window_line(child, -1);
    const std::int32_t upper = window_line(child, +1);
    cells_[at(child)].window_lower_line = lower;
    cells_[at(child)].window_upper_line = upper;
  }
  ranks_stale_ = true;
  return first;
}

std::int32_t AxisGrid::neighbour(std::int32_t cell, int direction) {
  std::int32_t climbed = 0;
  const auto is_last_sibling = [&](std::int32_t c) {
    const std::int32_t first = cells_[at(cells_[at(c)].parent)].first_child;
    return c == (direction > 0 ? first + grading_ - 1 : first);
  };
  while (cells_[at(cell)].depth > 0 && is_last_sibling(cell)) {
    cell = cells_[at(cell)].parent;
    ++climbed;
  }
  if (cells_[at(cell)].depth > 0) {
    cell += direction;
  } else {
    const std::int32_t index = cells_[at(cell)].lower_line + direction;  // line i is the integer i
    if (index < 0 || index >= length()) return kNone;
    cell = unit_cell(index);
  }
  for (; climbed > 0; --climbed) {
    split(cell);
    cell = cells_[at(cell)].first_child + (direction > 0 ? 0 : grading_ - 1);
  }
  return cell;
}

std::int32_t AxisGrid::window_line(std::int32_t cell, int direction) {
  for (int step = 0; step <= degree_; ++step) {
    const std::int32_t next = neighbour(cell, direction);
    if (next == kNone) break;
    cell = next;
  }
  return direction > 0 ? cells_[at(cell)].upper_line : cells_[at(cell)].lower_line;
}

/// Numbers the lines in the order of their coordinates: a walk through the cells from left to right, no comparison.
void AxisGrid::number_lines() {
  rank_of_line_.assign(lines_.size(), 0);
  line_of_rank_.assign(1, 0);
  std::vector<std::int32_t> pending;
  for (const std::int32_t unit : unit_cells_) {
    pending.push_back(unit);
    while (!pending.empty()) {
      const std::int32_t cell = pending.back();
      pending.pop_back();
      const std::int32_t first = cells_[at(cell)].first_child;
      if (first == kNone) {
        line_of_rank_.push_back(cells_[at(cell)].upper_line);
        continue;
      }
      for (std::int32_t child = first + grading_ - 1; child >= first; --child) pending.push_back(child);
    }
  }
  for (std::size_t rank = 0; rank < line_of_rank_.size(); ++rank) {
    rank_of_line_[at(line_of_rank_[rank])] = static_cast<std::int32_t>(rank);
  }
}

bool AxisGrid::windows_nested() const {
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    if (cells_[cell].depth <= 0 || cells_[cell].window_lower_line == kNone) continue;
    const RankInterval& own = window_[cell];
    const RankInterval& outer = window_[at(cells_[cell].parent)];
    if (own.lower < outer.lower || own.upper > outer.upper) return false;
  }
  return true;
}

void AxisGrid::update_ranks() {
  if (!ranks_stale_) return;
  number_lines();
  const auto interval = [this](std::int32_t lower, std::int32_t upper) -> RankInterval {
    if (lower == kNone) return {};
    return {rank_of_line(lower), rank_of_line(upper)};
  };
  extent_.clear();
  window_.clear();
  for (const Cell& cell : cells_) {
    extent_.push_back(interval(cell.lower_line, cell.upper_line));
    window_.push_back(interval(cell.window_lower_line, cell.window_upper_line));
  }
  ranks_stale_ = false;
}

}  // namespace asts
