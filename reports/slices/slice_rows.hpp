#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/slices/slice_drawing.hpp"

namespace asts {

/// A line beside the plot, parallel to one of the plane's axes, with ticks at exact coordinates: the axis itself, with
/// the ends of the elements that are cut; or a node's index vector, from its first to its last entry.
struct TickRow {
  struct Tick {
    Rational at;
    bool missing = false;    ///< not an entry of the node's vector, though of another's, and within its range
    std::string label = {};  ///< the coordinate
    int label_row = -1;      ///< labels that would touch stand in further rows; -1: there is no room
  };

  std::string name;
  std::optional<std::size_t> node;  ///< nothing: the axis itself
  std::vector<Tick> ticks;
  Px thickness = 0;
};

/// The rows for one of the plane's axes, 0 or 1, the axis first, then the marked nodes.
std::vector<TickRow> rows_along(const SliceGeometry& geometry, const SliceMarks& marks, std::size_t k,
                                const Rational& scale);

Px total_thickness(const std::vector<TickRow>& rows);

/// The rows of the first axis, below the plot, or of the second one, to its left.
void draw_rows(XmlNode svg, const Frame& frame, std::size_t k, const std::vector<TickRow>& rows);

}  // namespace asts
