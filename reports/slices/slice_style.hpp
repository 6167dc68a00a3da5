#pragma once

#include <optional>
#include <string>

#include "lib/mesh/axis.hpp"
#include "reports/slices/svg.hpp"

namespace asts {

/// Colours of Okabe and Ito, which readers with any kind of colour vision can tell apart; regions differ by hatching,
/// segments by dashes, and nodes by their shapes as well.
const char* region_colour(Axis region);
const char* node_colour(std::size_t node);

/// A grey for a level out of 0 to `highest`; the paper's white where the level is no integer.
std::string level_shade(std::optional<std::int32_t> level, std::int32_t highest);

/// The rules of `style`, for a page that shows several pictures.
const char* slice_styles();

/// `style` and the hatchings' `defs`.
void add_styles(XmlNode svg);

/// A node's sign: a circle, square, triangle or diamond, hollow when the node is not in the plane.
void add_marker(XmlNode parent, Px x, Px y, std::size_t node, bool hollow);
/// The sign of an entry that is missing.
void add_cross(XmlNode parent, Px x, Px y);
/// A region's name with its subscript, such as R_x.
void add_region_name(XmlNode parent, Px x, Px y, Axis region);

}  // namespace asts
