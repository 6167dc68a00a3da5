#include <fmt/format.h>

#include <algorithm>

#include "lib/mesh/refinement_tree.hpp"
#include "properties/describe.hpp"
#include "reports/paper/corner_view.hpp"
#include "reports/paper/paper.hpp"
#include "reports/paper/picture.hpp"
#include "reports/paper/text.hpp"

namespace asts {

namespace {

const Rational kScale = 170;

/// The children of the corner element of one level after the other, in one unit cube (Definition 2.6).
struct Subdivision {
  std::int32_t level;
  ExactBox element;
  Axis axis;
  std::vector<ExactBox> children;
};

Subdivision subdivide_corner(RefinementTree& tree) {
  const std::int32_t element = tree.leaf_at({});
  Subdivision result{tree.level(element), describe_tree_element(tree, element).box, tree.split_axis(element), {}};
  tree.subdivide(element);
  tree.update_ranks();
  for (std::int32_t i = 0; i < tree.child_count(element); ++i) {
    result.children.push_back(describe_tree_element(tree, tree.first_child(element) + i).box);
  }
  return result;
}

void draw_subdivision(XmlNode svg, const CornerView& view, const Subdivision& subdivision) {
  XmlNode group = add_group(svg, "subdivision");
  draw_box_edges(group, view, {{0, 0, 0}, {1, 1, 1}}, "ghost");
  std::vector<ExactBox> far_first = subdivision.children;
  if (!seen_above(subdivision.axis)) std::reverse(far_first.begin(), far_first.end());
  for (const ExactBox& child : far_first) draw_box(group, view, child, kPlain);
  name_axes(group, view);
  add_text(group, view.middle(), view.top + view.height() + px(34),
           fmt::format("level {}: {}-orthogonal", subdivision.level, axis_name(subdivision.axis)),
           {{"class", "panel middle"}});
}

}  // namespace

void add_subdivisions(Paper& paper) {
  RefinementTree tree({{3, 3, 3}, 3, {1, 1, 1}});
  std::vector<std::vector<std::string>> rows{{"level", "element", "cut orthogonal to", "children"}};
  Picture picture("Subdivision of an element of level 0, 1 and 2, m = 3", "");
  std::string description = "Three elements at the corner of a unit cube, each cut into three.";
  Px left = kPictureMargin;
  Px bottom = 0;
  for (int panel = 0; panel < kDimension; ++panel) {
    const Subdivision subdivision = subdivide_corner(tree);
    const CornerView view{{1, 1, 1}, kScale, left, Picture::top()};
    draw_subdivision(picture.svg(), view, subdivision);
    std::string children;
    for (const ExactBox& child : subdivision.children) children += (children.empty() ? "" : "; ") + box_text(child);
    rows.push_back(
        {std::to_string(subdivision.level), box_text(subdivision.element), axis_name(subdivision.axis), children});
    description += fmt::format(" {} of level {} becomes {}.", rows.back()[1], subdivision.level, children);
    left += view.width() + px(40);
    bottom = view.top + view.height() + px(34);
  }
  picture.svg().child("desc").text() = description.c_str();
  paper.files.push_back({"figure-subdivisions.svg", picture.finish(left - px(40), bottom)});
  paper.tables["subdivisions"] = markdown_table(rows);
}

}  // namespace asts
