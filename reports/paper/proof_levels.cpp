#include <fmt/format.h>

#include <algorithm>

#include "lib/exact/errors.hpp"
#include "lib/refine/replay.hpp"
#include "reports/paper/paper.hpp"
#include "reports/paper/proof_plane.hpp"

namespace asts {

namespace {

constexpr int kPixels = 26;

/// Where the level is at least `least`, K's child included.
PlaneRectangle levels_from(const ProofSlice& slice, std::int32_t least) {
  std::vector<PlaneRectangle> parts;
  for (const ElementTrace& element : slice.elements()) {
    if (element.level.value() >= least) parts.push_back(element.trace);
  }
  return filled_rectangle(parts);
}

struct Sets {
  std::vector<PlaneRectangle> patch;
  PlaneRectangle second_patch;
};

void draw_levels(XmlNode svg, const ProofPlane& plane, const ProofSlice& slice, const Sets& sets,
                 const std::string& caption) {
  XmlNode group = add_group(svg, "slice-levels");
  for (const PlaneRectangle& part : sets.patch) add_rect(group, plane.box(part), {{"fill", kBlue}});
  add_outline(group, plane.box(sets.second_patch), {{"class", "second"}});
  draw_cells(group, plane, slice.elements(), true);
  add_text(group, (plane.frame.plot.lower[0] + plane.frame.plot.upper[0]) / 2, plane.frame.plot.upper[1] + px(24),
           caption, {{"class", "panel middle"}});
}

std::vector<std::vector<std::string>> comparison(const ProofSlice& drawn, const ProofSlice& made) {
  const ProofFigure figure = drawn_proof_figure();
  std::vector<std::vector<std::string>> rows{{"on the slice, y x z", "drawn in the paper",
                                              "the definitions on the drawn levels",
                                              "the mesh that Algorithm 2.9 makes"}};
  for (std::int32_t level = 1; level <= 3; ++level) {
    rows.push_back({fmt::format("level at least {}", level), rectangle_text(in_units(figure.levels[at(level - 1)])),
                    rectangle_text(levels_from(drawn, level)), rectangle_text(levels_from(made, level))});
  }
  rows.push_back({"child of K, level 4", rectangle_text(in_units(figure.element)),
                  rectangle_text(levels_from(drawn, 4)), rectangle_text(levels_from(made, 4))});
  rows.push_back({"patch of K", rectangle_text(in_units(figure.patch)), rectangle_text(filled_rectangle(drawn.patch())),
                  rectangle_text(filled_rectangle(made.patch()))});
  rows.push_back({"second-order patch", rectangle_text(in_units(figure.second_patch)),
                  rectangle_text(filled_rectangle(drawn.second_patch())),
                  rectangle_text(filled_rectangle(made.second_patch()))});
  return rows;
}

}  // namespace

void add_proof_levels(const PaperCases& cases, Paper& paper) {
  const ProofFigure figure = drawn_proof_figure();
  const Case drawn_case = case_of_figure(figure, {3, 3, 3});
  const RefinementTree drawn_tree = mesh_after(drawn_case, drawn_case.steps.size());
  const RefinementTree made_tree = mesh_after(cases.proof, cases.proof.steps.size());
  MeshUnderTest drawn_mesh(drawn_tree);
  MeshUnderTest made_mesh(made_tree);
  const ProofSlice drawn(drawn_mesh, (drawn_case.domain[1] - ProofPlane::kSquares[0]) / 2);
  const ProofSlice made(made_mesh, 0);
  const auto rows = comparison(drawn, made);
  std::string description = "Two slices of 17 x 21 unit squares with the elements' levels as numbers.";
  for (std::size_t i = 1; i < rows.size(); ++i) {
    description += fmt::format(" {}: on the left {}, on the right {}.", rows[i][0], rows[i][1], rows[i][3]);
  }
  Picture picture("Levels on the slice in the proof of Theorem 5.3, m = 2, K of level 3", description);
  const ProofPlane left(kPictureMargin, Picture::top(), kPixels);
  const ProofPlane right(left.frame.plot.upper[0] + px(40), Picture::top(), kPixels);
  draw_levels(picture.svg(), left, drawn, {{in_units(figure.patch)}, in_units(figure.second_patch)},
              "as the paper draws it");
  draw_levels(picture.svg(), right, made, {made.patch(), filled_rectangle(made.second_patch())},
              "as Algorithm 2.9 makes it, p = (3,3,3)");
  Px bottom = picture.add_legend(kPictureMargin, right.frame.plot.upper[1] + px(44), {{kBlue, "patch of K"}});
  add_text(picture.svg(), kPictureMargin, bottom + px(12), "thick line: second-order patch; y to the right, z up");
  paper.files.push_back({"figure-proof-levels.svg", picture.finish(right.frame.plot.upper[0], bottom + px(12))});
  paper.tables["proof-levels"] = markdown_table(rows);
}

}  // namespace asts
