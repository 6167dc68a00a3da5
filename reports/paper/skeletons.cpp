#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "properties/describe.hpp"
#include "reports/paper/corner_view.hpp"
#include "reports/paper/paper.hpp"
#include "reports/paper/picture.hpp"
#include "reports/slices/slice_style.hpp"

namespace asts {

namespace {

const Rational kScale = 30;

/// The faces of Xi_axis (Definition 4.2) by the plane that they lie in, each rectangle once.
struct Skeleton {
  struct Plane {
    std::set<std::string> faces;  ///< as paths
    Rational area;                ///< of the faces seen from one side: they do not overlap
  };
  std::map<Rational, Plane> planes;
};

Rational shadow(const ExactBox& box, Axis axis) {
  Rational area = 1;
  for (Axis other = 0; other < kDimension; ++other) {
    if (other != axis) area *= box.upper[at(other)] - box.lower[at(other)];
  }
  return area;
}

/// The upper faces of elements tile the part of the plane that the skeleton has, but for the domain's lower side.
Skeleton skeleton_of(const RefinementTree& tree, Axis axis, const CornerView& view) {
  Skeleton skeleton;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (!tree.is_leaf(id)) continue;
    const ExactBox box = describe_tree_element(tree, id).box;
    const Rational& lower = box.lower[at(axis)];
    const Rational& upper = box.upper[at(axis)];
    skeleton.planes[upper].area += shadow(box, axis);
    if (lower.is_zero()) skeleton.planes[lower].area += shadow(box, axis);
    for (const Rational& place : {lower, upper}) {
      skeleton.planes[place].faces.insert(face_path(view, axis, place, box));
    }
  }
  return skeleton;
}

void draw_plane(XmlNode parent, const Skeleton::Plane& plane, Axis axis, bool whole) {
  std::string path;
  for (const std::string& face : plane.faces) path += face;
  add_node(parent, "path",
           {{"class", whole ? "whole" : "part"},
            {"fill", region_colour(axis)},
            {"fill-opacity", whole ? "0.04" : "0.5"},
            {"stroke", whole ? "#999999" : "#000000"},
            {"stroke-width", whole ? "0.25" : "0.6"},
            {"d", path}});
}

/// Far planes first, so that near ones are drawn over them.
void draw_skeleton(XmlNode parent, const Skeleton& skeleton, Axis axis, const Rational& side) {
  const auto draw = [&](const auto& plane) { draw_plane(parent, plane.second, axis, plane.second.area == side); };
  if (seen_above(axis)) {
    for (auto plane = skeleton.planes.begin(); plane != skeleton.planes.end(); ++plane) draw(*plane);
  } else {
    for (auto plane = skeleton.planes.rbegin(); plane != skeleton.planes.rend(); ++plane) draw(*plane);
  }
}

std::string partial_planes(const Skeleton& skeleton, const Rational& side) {
  std::string text;
  for (const auto& [place, plane] : skeleton.planes) {
    if (plane.area == side) continue;
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", to_string(place), to_string(plane.area));
  }
  return text;
}

}  // namespace

void add_skeletons(const PaperCases& cases, Paper& paper) {
  const RefinementTree tree = mesh_after(cases.refinement, cases.refinement.steps.size());
  const PerAxis<int>& n = tree.setting().domain;
  const ExactBox domain{{0, 0, 0}, {n[0], n[1], n[2]}};
  std::vector<std::vector<std::string>> rows{
      {"skeleton", "planes", "of them whole", "the others, place: area of the faces there", "a whole plane's area"}};
  std::string description = "The faces of one mesh, seen from below its corner at the origin.";
  Picture picture("The skeletons of the refined mesh of the refinement figure, p = (3,3,3), m = 3", "");
  Px left = kPictureMargin;
  Px bottom = 0;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const CornerView view{n, kScale, left, Picture::top()};
    const Skeleton skeleton = skeleton_of(tree, axis, view);
    const Rational side = shadow(domain, axis);
    XmlNode group = add_group(picture.svg(), "skeleton");
    draw_skeleton(group, skeleton, axis, side);
    draw_box_edges(group, view, domain, "ghost");
    name_axes(group, view);
    add_text(group, view.middle(), view.top + view.height() + px(30), fmt::format("{}-orthogonal", axis_name(axis)),
             {{"class", "panel middle"}});
    const auto whole = std::count_if(skeleton.planes.begin(), skeleton.planes.end(),
                                     [&](const auto& plane) { return plane.second.area == side; });
    rows.push_back({fmt::format("{}-orthogonal", axis_name(axis)), std::to_string(skeleton.planes.size()),
                    std::to_string(whole), partial_planes(skeleton, side), to_string(side)});
    description += fmt::format(" {}-orthogonal: {} planes, {} of them whole.", axis_name(axis), rows.back()[1], whole);
    left += view.width() + px(40);
    bottom = view.top + view.height() + px(50);
  }
  picture.svg().child("desc").text() = description.c_str();
  add_text(picture.svg(), kPictureMargin, bottom + px(12),
           "filled: planes that the skeleton has in part; outlined: whole planes, those of the initial mesh");
  paper.files.push_back({"figure-skeletons.svg", picture.finish(left - px(40), bottom + px(12))});
  paper.tables["skeletons"] = markdown_table(rows);
}

}  // namespace asts
