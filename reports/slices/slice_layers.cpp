#include <fmt/format.h>

#include <algorithm>

#include "reports/slices/slice_drawing.hpp"
#include "reports/slices/slice_style.hpp"

namespace asts {

namespace {

using Side = ElementTrace::Side;

/// Arrows tell on which side of the plane an element lies.
const char* arrow(Side side) {
  switch (side) {
    case Side::lower:
      return "\u2193";
    case Side::upper:
      return "\u2191";
    case Side::both:
      return "\u2195";
    case Side::through:
      break;
  }
  return "";
}

/// The level in a corner, the upper one, or the lower one for elements on the lower side, so that both can be read;
/// where there is room, away from the edges, along which outlines run.
void write_level(XmlNode group, const ElementTrace& element, const PxBox& box) {
  const bool one_sided = element.side == Side::lower || element.side == Side::upper;
  const std::string level = element.level ? std::to_string(*element.level) : "-";
  const bool room = box.width() >= text_width(level.size() + 2) && box.height() >= px(one_sided ? 26 : 14);
  if (!room) return;
  const Px away = std::min(box.width(), box.height()) >= px(60) ? px(17) : px(3);
  const Px y = element.side == Side::lower ? box.upper[1] - away : box.lower[1] + away + px(7);
  add_text(group, box.lower[0] + away, y, arrow(element.side) + level, {{"class", "level"}});
}

void draw_area(XmlNode svg, const Frame& frame, Axis region, const std::vector<PlaneRectangle>& parts) {
  XmlNode group = add_group(svg, "region-group");
  XmlNode area = add_node(group, "g",
                          {{"class", std::string("region ") + axis_name(region)},
                           {"fill", region_colour(region)},
                           {"stroke", region_colour(region)}});
  XmlNode hatching = add_node(group, "g", {{"fill", std::string("url(#hatch-") + axis_name(region) + ")"}});
  for (const PlaneRectangle& part : parts) {
    add_outline(area, frame.box(part));
    add_rect(hatching, frame.box(part));
  }
}

void draw_segments(XmlNode svg, const Frame& frame, Axis region, const std::vector<PlaneRectangle>& parts) {
  XmlNode group =
      add_node(svg, "g", {{"class", std::string("segments ") + axis_name(region)}, {"stroke", region_colour(region)}});
  for (const PlaneRectangle& part : parts) {
    const PxBox box = frame.box(part);
    if (box.width() == 0 && box.height() == 0) {
      add_rect(group, box.outset(px(4)), {{"fill", region_colour(region)}, {"stroke", "none"}});
    } else {
      add_line(group, box.lower[0], box.lower[1], box.upper[0], box.upper[1]);
    }
  }
}

/// Where a region's name stands: at the largest part, off its middle, where regions often meet.
std::array<Px, 2> name_place(const Frame& frame, const std::vector<PlaneRectangle>& parts) {
  const auto size = [&](const PlaneRectangle& part) {
    const PxBox box = frame.box(part);
    return std::pair(box.width() * box.height(), box.width() + box.height());
  };
  const auto largest =
      std::max_element(parts.begin(), parts.end(),
                       [&](const PlaneRectangle& one, const PlaneRectangle& other) { return size(one) < size(other); });
  const PxBox box = frame.box(*largest);
  return {box.lower[0] + box.width() * 3 / 4 + (box.width() == 0 ? px(7) : 0),
          box.lower[1] + box.height() / 4 + (box.height() == 0 ? px(17) : px(4))};
}

}  // namespace

void draw_elements(XmlNode svg, const SliceDrawing& drawing) {
  XmlNode fills = add_group(svg, "elements");
  XmlNode edges = add_group(svg, "edges");
  XmlNode levels = add_group(svg, "levels");
  const std::int32_t highest = drawing.geometry.highest_level;
  for (const ElementTrace& element : drawing.geometry.elements) {
    const PxBox box = drawing.frame.box(element.trace);
    add_rect(fills, box, {{"class", "element"}, {"fill", level_shade(element.level, highest)}});
    add_outline(edges, box, {{"class", element.side == Side::lower ? "edge lower" : "edge"}});
    write_level(levels, element, box);
  }
}

void draw_regions(XmlNode svg, const SliceDrawing& drawing) {
  if (!drawing.geometry.regions) return;
  XmlNode group = add_group(svg, "regions");
  const auto& regions = *drawing.geometry.regions;
  const Axis own = drawing.geometry.slice.axis;
  if (!regions[at(own)].empty()) draw_area(group, drawing.frame, own, regions[at(own)]);
  for (Axis region = 0; region < kDimension; ++region) {
    if (region != own && !regions[at(region)].empty()) {
      draw_segments(group, drawing.frame, region, regions[at(region)]);
    }
  }
}

void name_regions(XmlNode svg, const SliceDrawing& drawing) {
  if (!drawing.geometry.regions) return;
  for (Axis region = 0; region < kDimension; ++region) {
    const auto& parts = (*drawing.geometry.regions)[at(region)];
    if (parts.empty()) continue;
    const auto [right, down] = name_place(drawing.frame, parts);
    add_region_name(svg, right, down, region);
  }
}

void draw_borders(XmlNode svg, const SliceDrawing& drawing) {
  add_outline(svg, drawing.frame.plot, {{"class", "domain"}});
  if (drawing.geometry.active_region) {
    PxBox box = drawing.frame.box(*drawing.geometry.active_region);
    for (std::size_t k = 0; k < 2; ++k) {  // one without extent is drawn with some, so that it is seen
      if (box.lower[k] == box.upper[k]) {
        box.lower[k] -= px(12);
        box.upper[k] += px(12);
      }
    }
    add_outline(svg, box, {{"class", "active-region"}});
  }
  XmlNode nodes = add_group(svg, "active-nodes");
  for (const PlanePoint& node : drawing.geometry.active_nodes) {
    add_node(nodes, "circle",
             {{"class", "active-node"},
              {"cx", decimal(drawing.frame.x(node[0]))},
              {"cy", decimal(drawing.frame.y(node[1]))},
              {"r", "2.5"}});
  }
}

}  // namespace asts
