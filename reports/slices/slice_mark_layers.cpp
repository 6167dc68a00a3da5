#include <fmt/format.h>

#include "reports/slices/slice_drawing.hpp"
#include "reports/slices/slice_style.hpp"

namespace asts {

namespace {

/// " (z = 3)" behind the name of something that is not in the plane.
std::string place_off_plane(const SliceDrawing& drawing, const ExactPoint& point) {
  if (drawing.in_plane(point)) return {};
  const Axis axis = drawing.geometry.slice.axis;
  return fmt::format(" ({} = {})", axis_name(axis), to_string(point[at(axis)]));
}

/// Names of different nodes stand in different directions from the node, because nodes may project to one point.
void write_name(XmlNode svg, Px x, Px y, std::size_t node, const std::string& name) {
  const Px right = node % 4 == 0 || node % 4 == 3 ? px(11) : -px(11);
  const Px down = node % 2 == 0 ? -px(9) : px(17);
  add_text(svg, x + right, y + down, name, {{"class", right > 0 ? "halo" : "halo end"}});
}

/// Outlines on the same line would hide each other: each is a little inside the one before.
void draw_support(XmlNode svg, const SliceDrawing& drawing, std::size_t node, const ExactBox& support) {
  if (!drawing.in_plane(support)) return;
  static constexpr std::array dashes{"none", "12 4", "8 3 2 3", "4 4"};
  const Px inset = px(2) + px(4) * static_cast<Px>(node);
  add_outline(
      svg, drawing.frame.box(drawing.project(support)).outset(-inset),
      {{"class", "support"}, {"stroke", node_colour(node)}, {"stroke-dasharray", dashes[node % dashes.size()]}});
}

void draw_point(XmlNode svg, const SliceDrawing& drawing, const SliceMarks::Point& mark) {
  const PlanePoint place = drawing.project(mark.point);
  const Px x = drawing.frame.x(place[0]);
  const Px y = drawing.frame.y(place[1]);
  XmlNode group = add_group(svg, "witness-point");
  add_node(group, "circle", {{"class", "point"}, {"cx", decimal(x)}, {"cy", decimal(y)}, {"r", "11"}});
  for (const int side : {-1, 1}) {
    add_line(group, x + side * px(7), y, x + side * px(15), y, {{"class", "point"}});
    add_line(group, x, y + side * px(7), x, y + side * px(15), {{"class", "point"}});
  }
  add_text(group, x + px(15), y + px(5) - px(12), mark.name + place_off_plane(drawing, mark.point),
           {{"class", "halo"}});
}

}  // namespace

void draw_marks(XmlNode svg, const SliceDrawing& drawing) {
  for (const SliceMarks::Box& mark : drawing.marks.boxes) {
    if (!drawing.in_plane(mark.box)) continue;
    const PxBox box = drawing.frame.box(drawing.project(mark.box));
    add_outline(svg, box, {{"class", "box"}});
    add_text(svg, box.upper[0] - px(4), box.lower[1] + px(14), mark.name, {{"class", "halo end"}});
  }
  const std::vector<SliceMarks::Node>& nodes = drawing.marks.nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) draw_support(svg, drawing, i, nodes[i].info.support);
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const PlanePoint place = drawing.project(nodes[i].info.node);
    const Px x = drawing.frame.x(place[0]);
    const Px y = drawing.frame.y(place[1]);
    XmlNode group = add_group(svg, "marked-node");
    add_marker(group, x, y, i, !drawing.in_plane(nodes[i].info.node));
    write_name(group, x, y, i, nodes[i].name + place_off_plane(drawing, nodes[i].info.node));
  }
  for (const SliceMarks::Point& mark : drawing.marks.points) draw_point(svg, drawing, mark);
}

}  // namespace asts
