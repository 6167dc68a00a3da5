#include <fmt/format.h>

#include "lib/refine/refinement.hpp"
#include "properties/claims/example_table.hpp"
#include "properties/describe.hpp"
#include "reports/paper/corner_view.hpp"
#include "reports/paper/paper.hpp"
#include "reports/paper/picture.hpp"

namespace asts {

namespace {

const Rational kScale = 42;

/// The table of Example 2.10 as printed.
constexpr std::array<ExampleRow, 3> kPrinted{{{2, 12, 10728}, {4, 6, 3175}, {16, 3, 1030}}};

RefinementTree example_mesh(int grading, std::int64_t steps) {
  RefinementTree tree(example_setting(grading));
  for (std::int64_t step = 0; step < steps; ++step) {
    const std::int32_t corner = tree.leaf_at({});
    refine(tree, std::span(&corner, 1));
  }
  return tree;
}

void draw_example(XmlNode svg, const CornerView& view, const RefinementTree& tree, const ExampleRow& row) {
  XmlNode group = add_group(svg, "fine");
  draw_surface(group, view, tree, [&](std::int32_t leaf) { return grey_of(tree.level(leaf), tree.max_level()); });
  name_axes(group, view);
  add_text(group, view.middle(), view.top + view.height() + px(30), fmt::format("m = {}", row.grading),
           {{"class", "panel middle"}});
  add_text(group, view.middle(), view.top + view.height() + px(48),
           fmt::format("{} steps, {} new elements", row.steps, row.new_elements), {{"class", "middle"}});
}

}  // namespace

void add_example_meshes(Paper& paper) {
  std::vector<std::vector<std::string>> rows{{"m", "steps, paper", "steps, here", "new elements, paper",
                                              "new elements, here", "elements", "highest level", "agrees"}};
  std::string description = "Three meshes of 4 x 5 x 8 unit cubes seen from below the corner that is refined.";
  Picture picture("The meshes of Example 2.10, p = (3,3,3): the darker, the higher the level", "");
  Px left = kPictureMargin;
  Px bottom = 0;
  for (const ExampleRow& printed : kPrinted) {
    const ExampleRow found = run_example(example_setting(printed.grading));
    const RefinementTree tree = example_mesh(printed.grading, found.steps);
    const CornerView view{tree.setting().domain, kScale, left, Picture::top()};
    draw_example(picture.svg(), view, tree, found);
    const bool agrees = found.steps == printed.steps && found.new_elements == printed.new_elements &&
                        tree.new_element_count() == found.new_elements;
    rows.push_back({std::to_string(printed.grading), std::to_string(printed.steps), std::to_string(found.steps),
                    std::to_string(printed.new_elements), std::to_string(found.new_elements),
                    std::to_string(tree.element_count()), std::to_string(tree.max_level()), agrees ? "yes" : "no"});
    description += fmt::format(" m = {}: {} steps, {} new elements, {} elements.", found.grading, found.steps,
                               found.new_elements, tree.element_count());
    left += view.width() + px(40);
    bottom = view.top + view.height() + px(48);
  }
  picture.svg().child("desc").text() = description.c_str();
  paper.files.push_back({"figure-example-meshes.svg", picture.finish(left - px(40), bottom)});
  paper.tables["example-meshes"] = markdown_table(rows);
}

}  // namespace asts
