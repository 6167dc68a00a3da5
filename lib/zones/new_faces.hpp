#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// Where the faces that a step made cross lines parallel to their axis.
///
/// An element that is split along an axis (Definition 2.6) gets faces orthogonal to it, as wide as the element. So the
/// lines parallel to the axis that run through its closed rectangle have new entries there (Definition 4.3), and all
/// other entries are what they were: the step cuts old faces in pieces, but their union stays.
///
/// Cost: linear in the split elements and the given lines that run through each of them.
class NewFaces {
 public:
  /// Of elements that were split along an axis, on lines parallel to it through all pairs of a rank of the next axis
  /// and one of the axis after it. REQUIRES: both ascend strictly; up-to-date ranks.
  void assign(const RefinementTree& tree, Axis axis, std::span<const std::int32_t> elements,
              std::span<const std::int32_t> rows, std::span<const std::int32_t> columns);

  /// The ranks of the new entries on the line through a row and a column, by their places; they ascend, and may repeat.
  std::span<const std::int32_t> on(std::size_t row, std::size_t column) const {
    const std::size_t line = row * columns_ + column;
    return {entries_.data() + begin_[line], begin_[line + 1] - begin_[line]};
  }

 private:
  struct Crossing {
    std::size_t line;
    std::int32_t rank;
  };
  void sort_by_line();

  std::size_t columns_ = 0;
  std::vector<Crossing> crossings_;
  std::vector<std::size_t> begin_;  ///< by line, and one more
  std::vector<std::int32_t> entries_;
};

/// An index vector (Definition 4.4) after its line has got new entries: its middle entry stays, and on either side the
/// nearest ones are taken from the old entries and the new ones. All by ranks, ascending. The new ones may repeat, or
/// be old. Written to `result`. Cost: linear in both.
void insert_entries(std::span<const std::int32_t> old, std::span<const std::int32_t> entries,
                    std::vector<std::int32_t>& result);

}  // namespace asts
