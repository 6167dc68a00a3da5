#include "reports/paper/picture.hpp"

#include <fmt/format.h>

namespace asts {

namespace {

constexpr const char* kStyle = R"(
.paper text{font:12px 'DejaVu Sans',Verdana,sans-serif;fill:#000}
.paper .title{font-size:16px;font-weight:bold}
.paper .panel{font-size:13px;font-weight:bold}
.paper .middle{text-anchor:middle}
.paper .end{text-anchor:end}
.paper .level{font-size:9px;text-anchor:middle}
.paper .halo{paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}
.paper .face{stroke:#444;stroke-width:0.5;stroke-linejoin:round}
.paper .fine .face{stroke-width:0.25}
.paper .cell{fill:none;stroke:#666;stroke-width:0.6}
.paper .shadow{fill:#000;stroke:none}
.paper .border{fill:none;stroke:#000;stroke-width:1.4;stroke-linejoin:round}
.paper .ghost{fill:none;stroke:#777;stroke-width:0.8;stroke-dasharray:4 3}
.paper .environment{fill:none;stroke:#000;stroke-width:1.8;stroke-dasharray:6 3}
.paper .second{fill:none;stroke:#0072b2;stroke-width:4}
.paper .element{fill:none;stroke:#000;stroke-width:1.8}
)";

}  // namespace

Picture::Picture(const std::string& title, const std::string& description) {
  svg_ =
      add_node(document_, "svg",
               {{"xmlns", "http://www.w3.org/2000/svg"}, {"class", "paper"}, {"role", "img"}, {"aria-label", title}});
  add_node(svg_, "title").text() = title.c_str();
  add_node(svg_, "desc").text() = description.c_str();
  add_node(svg_, "style").text() = kStyle;
  add_node(svg_, "rect", {{"class", "ground"}, {"width", "100%"}, {"height", "100%"}, {"fill", "#ffffff"}});
  add_text(svg_, kPictureMargin, px(26), title, {{"class", "title"}});
}

Px Picture::add_legend(Px x, Px y, const std::vector<std::pair<std::string, std::string>>& rows) {
  XmlNode group = add_group(svg_, "legend");
  for (const auto& [colour, meaning] : rows) {
    add_rect(group, {{x, y}, {x + px(24), y + px(12)}}, {{"class", "face"}, {"fill", colour}});
    add_text(group, x + px(32), y + px(11), meaning);
    y += px(18);
  }
  return y;
}

std::string Picture::finish(Px right, Px bottom) {
  const std::string width = decimal(right + kPictureMargin);
  const std::string height = decimal(bottom + kPictureMargin);
  svg_.append_attribute("width") = width.c_str();
  svg_.append_attribute("height") = height.c_str();
  svg_.append_attribute("viewBox") = fmt::format("0 0 {} {}", width, height).c_str();
  return xml_text(document_);
}

}  // namespace asts
