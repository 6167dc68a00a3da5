#include "reports/slice_svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/slices/slice_rows.hpp"
#include "reports/slices/slice_style.hpp"

namespace asts {

namespace {

/// The longer side of the domain.
constexpr int kPlotPixels = 520;
constexpr Px kMargin = px(24);
constexpr Px kLegendWidth = px(390);
constexpr Px kSubtitleLine = px(15);

Rational scale_of(const PlaneRectangle& domain) {
  return kPlotPixels / std::max(domain.upper[0] - domain.lower[0], domain.upper[1] - domain.lower[1]);
}

/// The document's element with its text alternatives, styles and white ground; the size comes at the end.
XmlNode begin_svg(pugi::xml_document& document, const std::string& title, const std::string& description) {
  XmlNode svg =
      add_node(document, "svg",
               {{"xmlns", "http://www.w3.org/2000/svg"}, {"class", "slice"}, {"role", "img"}, {"aria-label", title}});
  add_node(svg, "title").text() = title.c_str();
  add_node(svg, "desc").text() = description.c_str();
  add_styles(svg);
  add_node(svg, "rect", {{"class", "ground"}, {"width", "100%"}, {"height", "100%"}, {"fill", "#ffffff"}});
  return svg;
}

void set_size(XmlNode svg, Px width, Px height) {
  svg.append_attribute("width") = decimal(width).c_str();
  svg.append_attribute("height") = decimal(height).c_str();
  svg.append_attribute("viewBox") = fmt::format("0 0 {} {}", decimal(width), decimal(height)).c_str();
}

/// The title and what is wrong; returns where they end.
Px draw_heading(XmlNode svg, const std::string& title, const std::string& says) {
  Px y = kMargin;
  add_text(svg, kMargin, y, title, {{"class", "title"}});
  for (const std::string& line : wrapped(says, 120)) add_text(svg, kMargin, y += kSubtitleLine, line);
  return y;
}

void draw_layers(XmlNode svg, const SliceDrawing& drawing) {
  draw_elements(svg, drawing);
  draw_regions(svg, drawing);
  draw_borders(svg, drawing);
  name_regions(svg, drawing);
  draw_marks(svg, drawing);
}

}  // namespace

std::string slice_svg(MeshUnderTest& mesh, const Slice& slice, const SliceMarks& marks) {
  const SliceGeometry geometry = cut(mesh, slice);
  const Rational scale = scale_of(geometry.domain);
  const auto below = rows_along(geometry, marks, 0, scale);
  const auto beside = rows_along(geometry, marks, 1, scale);

  pugi::xml_document document;
  const std::string title = slice_title(geometry);
  XmlNode svg = begin_svg(document, title, slice_description(geometry, marks));
  const Px top = draw_heading(svg, title, marks.says) + px(36);
  const Px left = kMargin + total_thickness(beside) + px(8);
  const PxBox plot{
      {left, top},
      {left + rounded_px(geometry.domain.upper[0] * scale), top + rounded_px(geometry.domain.upper[1] * scale)}};
  const SliceDrawing drawing{geometry, marks, axes_in(slice), {scale, plot}};
  draw_layers(svg, drawing);
  draw_rows(svg, drawing.frame, 0, below);
  draw_rows(svg, drawing.frame, 1, beside);
  const Px legend = draw_legend(svg, drawing, plot.upper[0] + px(40), top);
  set_size(svg, plot.upper[0] + px(40) + kLegendWidth,
           std::max(legend, plot.upper[1] + px(8) + total_thickness(below)) + kMargin);
  return xml_text(document);
}

std::string slice_name(const Slice& slice) {
  std::string position = to_string(slice.position);
  std::replace(position.begin(), position.end(), '/', '_');
  return std::string(axis_name(slice.axis)) + "-" + position;
}

std::vector<SlicePicture> slice_pictures(MeshUnderTest& mesh, const Witness* witness) {
  const SliceMarks marks = witness == nullptr ? SliceMarks{} : marks_of(*witness);
  std::vector<SlicePicture> pictures;
  for (const Slice& slice : slices_that_matter(witness, mesh.mesh().setting)) {
    pictures.push_back({slice, slice_name(slice), slice_svg(mesh, slice, marks)});
  }
  return pictures;
}

}  // namespace asts
