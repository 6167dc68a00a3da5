#include <fmt/format.h>

#include <set>

#include "reports/slices/slice_drawing.hpp"
#include "reports/slices/slice_style.hpp"

namespace asts {

namespace {

constexpr std::size_t kCharacters = 50;
constexpr Px kLineHeight = px(15);

class Legend {
 public:
  Legend(XmlNode svg, const SliceDrawing& drawing, Px x, Px y)
      : group_(add_group(svg, "legend")), drawing_(drawing), x_(x), y_(y) {}

  Px draw() {
    elements();
    regions();
    for (std::size_t i = 0; i < drawing_.marks.nodes.size(); ++i) node(i);
    if (!drawing_.marks.nodes.empty()) vectors();
    for (const SliceMarks::Point& mark : drawing_.marks.points) {
      add_node(group_, "circle",
               {{"class", "point"}, {"cx", decimal(swatch_middle())}, {"cy", decimal(y_ + px(6))}, {"r", "7"}});
      say(fmt::format("{} = {}", mark.name, point_text(mark.point)));
    }
    for (const SliceMarks::Box& mark : drawing_.marks.boxes) {
      if (!drawing_.in_plane(mark.box)) continue;
      add_outline(group_, swatch(), {{"class", "box"}});
      say(fmt::format("{}: the box from {} to {}", mark.name, point_text(mark.box.lower), point_text(mark.box.upper)));
    }
    return y_;
  }

 private:
  PxBox swatch() const { return {{x_, y_}, {x_ + px(26), y_ + px(12)}}; }
  Px swatch_middle() const { return x_ + px(13); }

  /// The text beside a sign; moves on.
  void say(const std::string& text) {
    for (const std::string& line : wrapped(text, kCharacters)) {
      add_text(group_, x_ + px(36), y_ + px(10), line);
      y_ += kLineHeight;
    }
    y_ += px(3);
  }

  void elements() {
    const std::int32_t highest = drawing_.geometry.highest_level;
    std::set<std::optional<std::int32_t>> levels;
    for (const ElementTrace& element : drawing_.geometry.elements) levels.insert(element.level);
    for (const auto& level : levels) {
      add_rect(group_, swatch(), {{"class", "edge"}, {"style", "fill:" + level_shade(level, highest)}});
      say(level ? fmt::format("element of level {}", *level) : "element whose level is no integer");
    }
    const char* axis = axis_name(drawing_.geometry.slice.axis);
    add_text(group_, x_ + px(2), y_ + px(10), "\u2191\u2193\u2195");
    say(fmt::format(
        "the plane has a face of the element, which lies at larger {0}, smaller {0}, or one on either side; "
        "no arrow: the plane cuts through it",
        axis));
    add_outline(group_, swatch(), {{"class", "edge lower"}});
    say(fmt::format("edges of elements at smaller {} only", axis));
    if (drawing_.geometry.active_region) {
      add_outline(group_, swatch(), {{"class", "active-region"}});
      active_region(*drawing_.geometry.active_region);
    }
    add_node(group_, "circle",
             {{"class", "active-node"}, {"cx", decimal(swatch_middle())}, {"cy", decimal(y_ + px(6))}, {"r", "2.5"}});
    say(fmt::format("active node in the plane: {}", drawing_.geometry.active_nodes.size()));
  }

  void active_region(const PlaneRectangle& region) {
    const bool flat = region.lower[0] == region.upper[0] || region.lower[1] == region.upper[1];
    say(fmt::format("active region{}{}", drawing_.geometry.in_active_region ? "" : ", projected: the plane misses it",
                    flat ? " (widened where it has no extent)" : ""));
  }

  void regions() {
    if (!drawing_.geometry.regions) return say("perturbed regions: none, since some index vector does not exist");
    for (Axis region = 0; region < kDimension; ++region) {
      const std::size_t parts = (*drawing_.geometry.regions)[at(region)].size();
      const bool own = region == drawing_.geometry.slice.axis;
      region_swatch(region, own);
      add_region_name(group_, x_ + px(36), y_ + px(10), region);
      add_text(group_, x_ + px(54), y_ + px(10), region_size(parts, own));
      y_ += kLineHeight + px(3);
    }
  }

  static std::string region_size(std::size_t parts, bool own) {
    if (parts == 0) return "perturbed region: nothing in the plane";
    const std::string what = own ? "rectangle" : "segment or point";
    const std::string whats = own ? "rectangles" : "segments or points";
    return fmt::format("perturbed region: {} {}", parts, parts == 1 ? what : whats);
  }

  void region_swatch(Axis region, bool own) {
    const std::string axis = axis_name(region);
    if (own) {
      add_rect(group_, swatch(), {{"fill", region_colour(region)}, {"opacity", "0.45"}});
      add_rect(group_, swatch(), {{"fill", "url(#hatch-" + axis + ")"}});
    } else {
      XmlNode group = add_node(group_, "g", {{"class", "segments " + axis}, {"stroke", region_colour(region)}});
      add_line(group, x_, y_ + px(6), x_ + px(26), y_ + px(6));
    }
  }

  void node(std::size_t i) {
    const SliceMarks::Node& mark = drawing_.marks.nodes[i];
    const bool in_plane = drawing_.in_plane(mark.info.node);
    add_marker(group_, swatch_middle(), y_ + px(6), i, !in_plane);
    say(fmt::format(
        "{} = {}{}; {}", mark.name, point_text(mark.info.node), in_plane ? "" : ", projected",
        drawing_.in_plane(mark.info.support) ? "line of this colour: its support" : "the plane misses its support"));
  }

  void vectors() {
    add_line(group_, x_, y_ + px(6), x_ + px(26), y_ + px(6), {{"class", "axis"}});
    for (const int tick : {0, 9, 17, 26}) {
      add_line(group_, x_ + px(tick), y_ + px(2), x_ + px(tick), y_ + px(10), {{"class", "axis"}});
    }
    say("beside the axes: a node's index vector, a tick an entry");
    if (drawing_.marks.missing.empty()) return;
    add_cross(group_, swatch_middle(), y_ + px(6));
    say("another node's entry that this vector lacks");
  }

  XmlNode group_;
  const SliceDrawing& drawing_;
  Px x_;
  Px y_;
};

}  // namespace

Px draw_legend(XmlNode svg, const SliceDrawing& drawing, Px x, Px y) { return Legend(svg, drawing, x, y).draw(); }

}  // namespace asts
