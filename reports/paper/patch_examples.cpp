#include <fmt/format.h>

#include <algorithm>

#include "properties/claims/patch_relation.hpp"
#include "properties/describe.hpp"
#include "reports/paper/corner_view.hpp"
#include "reports/paper/paper.hpp"
#include "reports/paper/picture.hpp"
#include "reports/paper/text.hpp"

namespace asts {

namespace {

const Rational kScale = 26;

/// An element of a mesh and its patch (Definition 2.4).
struct PatchExample {
  RefinementTree tree;
  std::int32_t element;
  Elements patch;

  explicit PatchExample(RefinementTree mesh) : tree(std::move(mesh)), element(tree.leaf_at({})) {
    for (const std::int32_t leaf : leaves_in_order(tree)) {
      if (in_patch(tree, element, leaf)) patch.push_back(leaf);
    }
  }

  std::int32_t level() const { return tree.level(element); }
  std::int64_t of_level(std::int32_t wanted) const {
    return std::count_if(patch.begin(), patch.end(), [&](std::int32_t id) { return tree.level(id) == wanted; });
  }
};

/// D(level(K)): p + 3/2 element lengths along each axis.
ExactPoint reach(const PatchExample& example) {
  const ExactBox box = describe_tree_element(example.tree, example.element).box;
  ExactPoint result;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    result[axis] = (box.upper[axis] - box.lower[axis]) * (example.tree.setting().degree[axis] + Rational(3, 2));
  }
  return result;
}

void draw_environment(XmlNode parent, const CornerView& view, const ExactBox& environment) {
  for (const Axis axis : {0, 1}) {
    add_node(parent, "path", {{"class", "environment"}, {"d", face_path(view, axis, 0, environment)}});
  }
}

void draw_example(XmlNode svg, const CornerView& view, const PatchExample& example) {
  XmlNode group = add_group(svg, "mesh");
  draw_surface(group, view, example.tree, [&](std::int32_t leaf) {
    if (leaf == example.element) return kVermilion;
    return in_patch(example.tree, example.element, leaf) ? kBlue : kPlain;
  });
  draw_environment(group, view, describe_environment(example.tree, example.element));
  name_axes(group, view);
  add_text(group, view.middle(), view.top + view.height() + px(30), fmt::format("level of K: {}", example.level()),
           {{"class", "panel middle"}});
}

std::vector<std::string> row_of(const PatchExample& example) {
  const std::int32_t level = example.level();
  return {std::to_string(level),
          box_text(describe_tree_element(example.tree, example.element).box),
          point_text_of(reach(example)),
          box_text(describe_environment(example.tree, example.element)),
          std::to_string(example.patch.size()),
          std::to_string(example.of_level(level)),
          std::to_string(example.of_level(level - 1)),
          std::to_string(example.tree.element_count())};
}

}  // namespace

void add_patch_examples(const PaperCases& cases, Paper& paper) {
  Case marks = cases.refinement;
  marks.steps.resize(4, marks.steps.front());  // the corner element, until it has level 4
  std::vector<std::vector<std::string>> rows{
      {"level of K", "K", "D", "U(K)", "elements in the patch", "of K's level", "one level coarser", "in the mesh"}};
  std::string description = "Three meshes seen from below their corner at the origin, where K is.";
  Picture picture("Patches of an element K of level 2, 3 and 4, p = (3,3,3), m = 3", "");
  Px left = kPictureMargin;
  Px bottom = 0;
  for (const std::size_t level : {2, 3, 4}) {
    const PatchExample example(mesh_after(marks, level));
    const CornerView view{
        marks.domain,
        kScale,
        left,
        Picture::top(),
    };
    draw_example(picture.svg(), view, example);
    rows.push_back(row_of(example));
    description += fmt::format(" K = {} of level {} has a patch of {} elements; its environment is {}.", rows.back()[1],
                               level, example.patch.size(), rows.back()[3]);
    left += view.width() + px(40);
    bottom = view.top + view.height() + px(50);
  }
  picture.svg().child("desc").text() = description.c_str();
  bottom = picture.add_legend(
      kPictureMargin, bottom,
      {{kVermilion, "K"}, {kBlue, "the other elements of its patch"}, {kPlain, "elements outside the patch"}});
  add_text(picture.svg(), kPictureMargin, bottom + px(12), "dashed: the environment U(K) on the domain's sides");
  paper.files.push_back({"figure-patches.svg", picture.finish(left - px(40), bottom + px(12))});
  paper.tables["patches"] = markdown_table(rows);
}

}  // namespace asts
