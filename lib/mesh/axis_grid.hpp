#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/exact/grid_coordinate.hpp"
#include "lib/mesh/axis.hpp"

namespace asts {

/// An open or closed interval between two lines of an axis, by their ranks.
struct RankInterval {
  std::int32_t lower = 0;
  std::int32_t upper = 0;
};

/// One axis of the index domain: the m-adic hierarchy of its intervals ("cells"), as far as a mesh needs it.
///
/// Vocabulary. The unit cells are [i-1, i]; a cell of depth s has length m^-s and m children of depth s+1. Above the
/// unit cells a binary hierarchy of "block cells" (depth -1) ends in one root cell, the whole axis. A "line" is an end
/// of a cell. Cells and lines have 32-bit identifiers that never change; all elements that share a side share the
/// identifier, so that an element of any depth is three numbers. What a line's coordinate is, is known exactly
/// (GridCoordinate); comparisons need only its rank, the line's place in the order of all lines.
///
/// The window of a cell is the interval that reaches p+1 cells of the same depth beyond either end, cut off at the
/// ends of the axis. It is the extent of the environment U(K) (Definition 2.4) of an element K with that cell:
/// by the definition of D(k), U(K) reaches (p+3/2) element lengths from the midpoint, that is p+1 from the sides,
/// in each direction and for each of the three cases k mod 3.
///
/// Laws: (1) neighbours of one depth share a line; (2) ranks grow with coordinates; (3) depth has no bound.
/// Cost: memory is linear in the lines of one axis, not in the elements of the mesh.
class AxisGrid {
 public:
  static constexpr std::int32_t kNone = -1;

  /// REQUIRES: length >= 1, grading >= 2, degree >= 1.
  AxisGrid(int length, int grading, int degree);

  int length() const { return static_cast<int>(unit_cells_.size()); }
  std::int32_t root() const { return 0; }
  /// The cell [index, index + 1]. REQUIRES: 0 <= index < length().
  std::int32_t unit_cell(int index) const { return unit_cells_[at(index)]; }
  bool is_block(std::int32_t cell) const { return cells_[at(cell)].depth < 0; }
  /// Number of unit cells in a block cell or 1.
  int units_in(std::int32_t cell) const { return cells_[at(cell)].units; }

  /// The first of the contiguous children: 2 of a block cell, m of the others; made, with their windows, when missing.
  std::int32_t children(std::int32_t cell);

  /// The same, but kNone where there are none yet.
  std::int32_t known_children(std::int32_t cell) const { return cells_[at(cell)].first_child; }

  /// Whether children() would make nothing.
  bool has_children(std::int32_t cell) const {
    const std::int32_t first = cells_[at(cell)].first_child;
    return first != kNone && (is_block(cell) || cells_[at(first)].window_lower_line != kNone);
  }
  std::int32_t cell_count() const { return static_cast<std::int32_t>(cells_.size()); }

  /// Ranks of a cell's ends and of its window's ends. REQUIRES: update_ranks() since the last call of children().
  RankInterval extent(std::int32_t cell) const { return extent_[at(cell)]; }
  RankInterval window(std::int32_t cell) const { return window_[at(cell)]; }

  /// Whether the window of each cell lies in that of its parent, as far as windows are known. Then U(K') lies in U(K)
  /// for every child K' of an element K: they have the same cell along two axes. Cost: linear in cells.
  /// REQUIRES: ranks are up to date.
  bool windows_nested() const;

  /// Renumbers the lines if new ones came. Cost: linear in cells when there are new lines, constant otherwise.
  void update_ranks();

  std::int32_t line_count() const { return static_cast<std::int32_t>(lines_.size()); }
  /// The line of a rank; REQUIRES: ranks are up to date.
  std::int32_t line_of_rank(std::int32_t rank) const { return line_of_rank_[at(rank)]; }
  std::int32_t rank_of_line(std::int32_t line) const { return rank_of_line_[at(line)]; }
  Rational coordinate(std::int32_t line) const { return lines_[at(line)].to_rational(); }
  int grading() const { return grading_; }
  /// A line's coordinate is index / m^depth, and m does not divide the index unless the depth is 0.
  std::int32_t line_depth(std::int32_t line) const { return lines_[at(line)].depth(); }
  /// Nothing when it does not fit into 64 bits.
  std::optional<std::int64_t> small_line_index(std::int32_t line) const {
    const GridCoordinate& coordinate = lines_[at(line)];
    if (!coordinate.is_small()) return std::nullopt;
    return coordinate.small_index();
  }

 private:
  struct Cell {
    std::int32_t parent;
    std::int32_t first_child;
    std::int32_t lower_line;
    std::int32_t upper_line;
    std::int32_t window_lower_line;
    std::int32_t window_upper_line;
    std::int32_t depth;  ///< -1 for block cells
    std::int32_t units;
  };

  std::int32_t add_cell(std::int32_t parent, std::int32_t lower_line, std::int32_t upper_line, std::int32_t depth);
  void build_blocks();
  void split(std::int32_t cell);
  /// The neighbour of the same depth in direction +1 or -1, made when missing; kNone beyond the axis.
  std::int32_t neighbour(std::int32_t cell, int direction);
  std::int32_t window_line(std::int32_t cell, int direction);
  void number_lines();

  int grading_;
  int degree_;
  std::vector<Cell> cells_;
  std::vector<std::int32_t> unit_cells_;
  std::vector<GridCoordinate> lines_;
  std::vector<std::int32_t> rank_of_line_;
  std::vector<std::int32_t> line_of_rank_;
  std::vector<RankInterval> extent_;
  std::vector<RankInterval> window_;
  bool ranks_stale_ = true;
};

}  // namespace asts
