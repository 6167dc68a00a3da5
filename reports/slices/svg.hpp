#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "lib/exact/rational.hpp"

namespace asts {

/// The parts of an SVG picture, as XML nodes, so that what is written is always well-formed. Lengths are whole
/// hundredths of a pixel: the same picture has the same bytes on every machine.

using XmlNode = pugi::xml_node;

/// Hundredths of a pixel.
using Px = std::int64_t;
constexpr Px px(std::int64_t pixels) { return 100 * pixels; }

/// "12.50"
std::string decimal(Px length);

/// The integer nearest to 100 times a number of pixels, halves up.
Px rounded_px(const Rational& pixels);

/// A rectangle on the canvas, y growing downwards; it may be a segment or a point.
struct PxBox {
  std::array<Px, 2> lower;
  std::array<Px, 2> upper;

  Px width() const { return upper[0] - lower[0]; }
  Px height() const { return upper[1] - lower[1]; }
  PxBox outset(Px by) const { return {{lower[0] - by, lower[1] - by}, {upper[0] + by, upper[1] + by}}; }
};

using Attributes = std::initializer_list<std::pair<const char*, std::string>>;

XmlNode add_node(XmlNode parent, const char* name, Attributes attributes = {});
XmlNode add_group(XmlNode parent, const char* css_class);
/// `rect`: not drawn at all when it has no area.
XmlNode add_rect(XmlNode parent, const PxBox& box, Attributes attributes = {});
/// The same as a closed path, whose stroke is drawn also where it is a segment or a point.
XmlNode add_outline(XmlNode parent, const PxBox& box, Attributes attributes = {});
XmlNode add_line(XmlNode parent, Px x1, Px y1, Px x2, Px y2, Attributes attributes = {});
XmlNode add_text(XmlNode parent, Px x, Px y, const std::string& text, Attributes attributes = {});

/// At least what a text of that many characters takes at 11 pixels.
constexpr Px text_width(std::size_t characters) { return px(7) * static_cast<Px>(characters); }

/// Breaks a text between words into lines of at most `characters` characters, where words allow it.
std::vector<std::string> wrapped(const std::string& text, std::size_t characters);

/// Rows for labels of given centres and lengths, so that none touches another in its row: the lowest row with room for
/// each, in the order given; -1 where none of the rows has room. Cost: quadratic in the labels that have room.
std::vector<int> stagger(const std::vector<std::pair<Px, Px>>& centres_and_lengths, int rows);

std::string xml_text(const pugi::xml_document& document);

}  // namespace asts
