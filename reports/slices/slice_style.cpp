#include "reports/slices/slice_style.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asts {

namespace {

constexpr const char* kStyles = R"(
.slice text{font:11px 'DejaVu Sans',Verdana,sans-serif;fill:#000}
.slice .title{font-size:15px;font-weight:bold}
.slice .level{fill:#555;font-size:9px}
.slice .subscript{font-size:8px}
.slice .end{text-anchor:end}
.slice .middle{text-anchor:middle}
.slice .halo{paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}
.slice .edge{fill:none;stroke:#777;stroke-width:0.8}
.slice .edge.lower{stroke-dasharray:3 2}
.slice .domain{fill:none;stroke:#000;stroke-width:2}
.slice .active-region{fill:none;stroke:#000;stroke-width:1.6;stroke-dasharray:7 4}
.slice .active-node{fill:#000}
.slice .support{fill:none;stroke-width:2.4}
.slice .box{fill:none;stroke:#000;stroke-width:2.4;stroke-dasharray:2 2}
.slice .region{stroke-linejoin:round;stroke-linecap:round;stroke-width:5;opacity:0.45}
.slice .segments{fill:none;stroke-linejoin:round;stroke-linecap:butt;stroke-width:6}
.slice .segments.x{stroke-dasharray:none}
.slice .segments.y{stroke-dasharray:9 5}
.slice .segments.z{stroke-dasharray:3 3}
.slice .row{stroke-width:1.8}
.slice .axis{stroke:#000;stroke-width:1}
.slice .cross{fill:none;stroke:#000;stroke-width:2}
.slice .point{fill:none;stroke:#000;stroke-width:2}
)";

std::string moved(Px x, Px y) { return fmt::format("{} {}", decimal(x), decimal(y)); }

void add_hatching(XmlNode defs, Axis region, const char* path) {
  XmlNode pattern = add_node(defs, "pattern",
                             {{"id", std::string("hatch-") + axis_name(region)},
                              {"patternUnits", "userSpaceOnUse"},
                              {"width", "8"},
                              {"height", "8"}});
  add_node(pattern, "path",
           {{"d", path}, {"stroke", region_colour(region)}, {"stroke-width", "1.6"}, {"fill", "none"}});
}

}  // namespace

const char* slice_styles() { return kStyles; }

const char* region_colour(Axis region) {
  static constexpr PerAxis<const char*> colours{"#d55e00", "#0072b2", "#009e73"};
  return colours[at(region)];
}

const char* node_colour(std::size_t node) {
  static constexpr std::array colours{"#cc79a7", "#e69f00", "#56b4e9", "#000000"};
  return colours[node % colours.size()];
}

std::string level_shade(std::optional<std::int32_t> level, std::int32_t highest) {
  constexpr std::int32_t kLightest = 250;
  constexpr std::int32_t kDarkest = 190;
  constexpr std::int32_t kStep = 14;  // not darker than the eye needs
  if (!level) return "#ffffff";
  const std::int64_t range = std::min<std::int64_t>(kLightest - kDarkest, std::int64_t{kStep} * highest);
  const auto darker = highest == 0 ? 0 : range * std::clamp(*level, 0, highest) / highest;
  return fmt::format("#{0:02x}{0:02x}{0:02x}", kLightest - darker);
}

void add_styles(XmlNode svg) {
  add_node(svg, "style").text() = kStyles;
  XmlNode defs = add_node(svg, "defs");
  static constexpr PerAxis<const char*> paths{"M-2 10L10 -2M-2 2L2 -2M6 10L10 6", "M-2 -2L10 10M6 -2L10 2M-2 6L2 10",
                                              "M0 2H8M0 6H8"};
  for (Axis region = 0; region < kDimension; ++region) add_hatching(defs, region, paths[at(region)]);
}

void add_marker(XmlNode parent, Px x, Px y, std::size_t node, bool hollow) {
  const Px r = px(5) + px(3) * static_cast<Px>(hollow);
  static constexpr std::array<std::array<std::array<int, 2>, 4>, 3> shapes{{
      {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}},  // square
      {{{0, -1}, {1, 1}, {-1, 1}, {0, -1}}},   // triangle
      {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}},    // diamond
  }};
  const Attributes look{{"class", hollow ? "node hollow" : "node"},
                        {"fill", hollow ? "none" : node_colour(node)},
                        {"stroke", hollow ? node_colour(node) : "#000000"},
                        {"stroke-width", hollow ? "2.4" : "1.2"}};
  const std::size_t shape = node % (shapes.size() + 1);
  if (shape == 0) {
    XmlNode circle = add_node(parent, "circle", look);
    circle.append_attribute("cx") = decimal(x).c_str();
    circle.append_attribute("cy") = decimal(y).c_str();
    circle.append_attribute("r") = decimal(r).c_str();
    return;
  }
  std::string path;
  for (const auto& [right, down] : shapes[shape - 1]) {
    path += (path.empty() ? "M" : "L") + moved(x + right * r, y + down * r);
  }
  add_node(parent, "path", look).append_attribute("d") = (path + "Z").c_str();
}

void add_cross(XmlNode parent, Px x, Px y) {
  const Px r = px(4);
  add_node(parent, "path",
           {{"class", "cross"},
            {"d", fmt::format("M{}L{}M{}L{}", moved(x - r, y - r), moved(x + r, y + r), moved(x - r, y + r),
                              moved(x + r, y - r))}});
}

void add_region_name(XmlNode parent, Px x, Px y, Axis region) {
  XmlNode text = add_text(parent, x, y, "R", {{"class", "halo"}});
  add_node(text, "tspan", {{"class", "subscript"}, {"dy", "3"}}).text() = axis_name(region);
}

}  // namespace asts
