#include "reports/html/shown_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "lib/exact/errors.hpp"
#include "lib/refine/replay.hpp"
#include "properties/mesh_under_test.hpp"
#include "reports/html/mesh_view.hpp"
#include "reports/slice_svg.hpp"

namespace asts {

namespace {

/// Larger meshes are not drawn: a page must open, and `asts draw` is there for one slice.
constexpr std::int64_t kMostElements = 200'000;
/// Nor more meshes than people look at.
constexpr int kMostMeshes = 60;

std::int64_t initial_elements(const Case& content) {
  std::int64_t result = 1;
  for (const int length : content.domain) result *= length;
  return result;
}

/// The last mesh of a case with the tree behind it; nothing when it gets too large.
struct LastMesh {
  explicit LastMesh(const Case& content) {
    if (content.explicit_mesh) {
      if (static_cast<std::int64_t>(content.elements.size()) > kMostElements) return;
      mesh = std::make_unique<MeshUnderTest>(mesh_of(setting_of(content), content.elements));
      return;
    }
    if (initial_elements(content) > kMostElements) return;
    replay.emplace(content);
    while (!replay->done()) {
      replay->advance();
      if (replay->tree().element_count() > kMostElements) return;
    }
    mesh = std::make_unique<MeshUnderTest>(replay->tree());
  }

  std::optional<Replay> replay;
  std::unique_ptr<MeshUnderTest> mesh;
};

/// Environments and supports reach beyond the domain by a few cubes; what lies further away is no place in it.
bool is_near(const ExactPoint& point, const Setting& setting) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const Rational margin = setting.degree[at(axis)] + 2;
    if (point[at(axis)] < -margin || point[at(axis)] > setting.domain[at(axis)] + margin) return false;
  }
  return true;
}

bool is_near(const ExactBox& box, const Setting& setting) {
  return is_near(box.lower, setting) && is_near(box.upper, setting);
}

SliceMarks near_marks(const Witness* witness, const Setting& setting) {
  if (witness == nullptr) return {};
  SliceMarks marks = marks_of(*witness);
  std::erase_if(marks.nodes, [&](const SliceMarks::Node& node) {
    return !is_near(node.info.node, setting) || !is_near(node.info.support, setting);
  });
  std::erase_if(marks.points, [&](const SliceMarks::Point& point) { return !is_near(point.point, setting); });
  std::erase_if(marks.boxes, [&](const SliceMarks::Box& box) { return !is_near(box.box, setting); });
  return marks;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

/// A copy of a picture without its own style, which the page has once, with hatchings of its own names.
void add_svg(HtmlNode parent, std::string svg, int number) {
  for (const std::string begin : {"id=\"hatch-", "url(#hatch-"}) {
    replace_all(svg, begin, begin + std::to_string(number) + "-");
  }
  pugi::xml_document document;
  ensure(static_cast<bool>(document.load_string(svg.c_str(), pugi::parse_default | pugi::parse_ws_pcdata_single)),
         "a picture is XML");
  HtmlNode picture = parent.append_copy(document.document_element());
  picture.remove_child("style");  // page_text() has it
}

/// The first picture gives way to the interactive view where there are scripts.
std::string caption(const std::string& name, const Slice& slice, bool first) {
  return fmt::format("{}{} slice {} = {}", name, first ? ". On paper and without scripts:" : ",", axis_name(slice.axis),
                     to_string(slice.position));
}

}  // namespace

void MeshGallery::add(HtmlNode parent, const ShownMesh& shown) {
  if (views_ == kMostMeshes) {
    add_paragraph(parent, fmt::format("{} is not drawn here, after {} meshes; asts draw does.", shown.name, views_));
    return;
  }
  const LastMesh last(*shown.content);
  if (last.mesh == nullptr) {
    add_paragraph(parent, fmt::format("{} has more than {} elements and is not drawn here; asts draw does.", shown.name,
                                      kMostElements));
    return;
  }
  MeshUnderTest& mesh = *last.mesh;
  const Setting setting = setting_of(*shown.content);
  const SliceMarks marks = near_marks(shown.witness, setting);
  HtmlNode figure;
  try {
    for (const Slice& slice : slices_that_matter(shown.witness, setting)) {
      const std::string svg = slice_svg(mesh, slice, marks);
      const bool first = !figure;
      figure = add_html(parent, "figure", {{"class", first ? "mesh-view" : "picture"}, {"tabindex", "0"}});
      if (first) figure.append_attribute("id") = fmt::format("view-{}", ++views_).c_str();
      add_svg(figure, svg, ++pictures_);
      add_html(figure, "figcaption", {}, caption(shown.name, slice, first));
      if (!first) continue;
      const std::string json = script_json(mesh_view_json(mesh, shown.witness));
      add_html(figure, "script", {{"type", "application/json"}, {"class", "mesh-data"}}, json);
    }
  } catch (const BudgetExhausted& reason) {
    add_paragraph(parent, shown.name + " is not drawn: " + reason.what());
  }
}

}  // namespace asts
