#include <fmt/format.h>

#include <algorithm>

#include "lib/exact/errors.hpp"
#include "reports/paper/paper.hpp"
#include "reports/paper/proof_plane.hpp"
#include "reports/slices/slice_style.hpp"

namespace asts {

namespace {

constexpr int kPixels = 22;

struct Regions {
  PerAxis<std::vector<PlaneRectangle>> on_slice;
  std::vector<PlaneRectangle> x_elsewhere;
};

/// The ring as four rectangles.
std::vector<PlaneRectangle> drawn_ring(const ProofFigure& figure) {
  const PlaneRectangle out = in_units(figure.ring_outside);
  const PlaneRectangle in = in_units(figure.ring_inside);
  return {{out.lower, {in.lower[0], out.upper[1]}},
          {{in.upper[0], out.lower[1]}, out.upper},
          {{in.lower[0], out.lower[1]}, {in.upper[0], in.lower[1]}},
          {{in.lower[0], in.upper[1]}, {in.upper[0], out.upper[1]}}};
}

Regions drawn_regions(const ProofFigure& figure) {
  Regions regions{{std::vector{in_units(figure.sigma)}, {}, {}}, drawn_ring(figure)};
  for (const auto& line : figure.lines_y) regions.on_slice[1].push_back(in_units(line));
  for (const auto& line : figure.lines_z) regions.on_slice[2].push_back(in_units(line));
  return regions;
}

Regions regions_of(const ProofSlice& slice) {
  return {{slice.region(0), slice.region(1), slice.region(2)}, slice.region_x_elsewhere()};
}

/// One path, so that parts that overlap are no darker.
void draw_areas(XmlNode parent, const ProofPlane& plane, const std::vector<PlaneRectangle>& parts,
                const char* opacity) {
  std::string areas;
  for (const PlaneRectangle& part : parts) {
    const PxBox box = plane.box(part);
    areas += fmt::format("M{} {}H{}V{}H{}Z", decimal(box.lower[0]), decimal(box.lower[1]), decimal(box.upper[0]),
                         decimal(box.upper[1]), decimal(box.lower[0]));
  }
  add_node(parent, "path", {{"class", "region x"}, {"fill", region_colour(0)}, {"opacity", opacity}, {"d", areas}});
}

void draw_regions(XmlNode parent, const ProofPlane& plane, const Regions& regions) {
  draw_areas(parent, plane, regions.x_elsewhere, "0.25");
  draw_areas(parent, plane, regions.on_slice[0], "0.6");
  for (const Axis axis : {1, 2}) {
    XmlNode lines = add_node(
        parent, "g",
        {{"class", std::string("region ") + axis_name(axis)}, {"stroke", region_colour(axis)}, {"stroke-width", "4"}});
    for (const PlaneRectangle& part : regions.on_slice[at(axis)]) {
      const PxBox box = plane.box(part);
      add_line(lines, box.lower[0], box.upper[1], box.upper[0], box.lower[1]);
    }
  }
}

void draw_panel(XmlNode svg, const ProofPlane& plane, const ProofSlice& slice, const Regions& regions,
                const std::string& caption) {
  XmlNode group = add_group(svg, "slice-perturbations");
  draw_cells(group, plane, slice.elements(), false);
  draw_regions(group, plane, regions);
  add_outline(group, plane.frame.plot, {{"class", "border"}});
  add_text(group, (plane.frame.plot.lower[0] + plane.frame.plot.upper[0]) / 2, plane.frame.plot.upper[1] + px(24),
           caption, {{"class", "panel middle"}});
}

/// "y = 11/2, 13/2, ..., 23/2; z in [5,8] and [13,16]" for lines across an axis, which come in pairs of pieces.
std::string lines_text(const std::vector<ProofFigure::Rectangle>& lines, std::size_t axis) {
  const PlaneRectangle first = in_units(lines[0]);
  const PlaneRectangle second = in_units(lines[1]);
  const PlaneRectangle last = in_units(lines.back());
  const char* names[] = {"y", "z"};
  const std::size_t along = 1 - axis;
  return fmt::format("{} = {}, ..., {}; {} in [{},{}] and [{},{}]", names[axis], to_string(first.lower[axis]),
                     to_string(last.lower[axis]), names[along], to_string(first.lower[along]),
                     to_string(first.upper[along]), to_string(second.lower[along]), to_string(second.upper[along]));
}

std::vector<std::vector<std::string>> texts_of(const ProofFigure& figure) {
  return {{"Sigma", rectangle_text(in_units(figure.sigma))},
          {"Rx besides Sigma: inside", rectangle_text(in_units(figure.ring_outside))},
          {"... and outside the interior of", rectangle_text(in_units(figure.ring_inside))},
          {"Ry", lines_text(figure.lines_y, 0)},
          {"Rz", lines_text(figure.lines_z, 1)}};
}

struct Checked {
  Case content;
  RefinementTree tree;
  MeshUnderTest mesh;
  FigureItems items;

  Checked(const ProofFigure& levels, const ProofFigure& compared)
      : content(case_of_figure(levels, {3, 3, 3})), tree(mesh_after(content, content.steps.size())), mesh(tree) {
    items = items_of_figure(mesh, find_drawn_element(mesh, levels).value(), compared);
  }
  int margin() const { return (content.domain[1] - ProofPlane::kSquares[0]) / 2; }
};

std::vector<std::vector<std::string>> item_rows(const FigureItems& drawn, const FigureItems& correct) {
  std::vector<std::vector<std::string>> rows{
      {"what is drawn", "the drawn mesh has it, p = (3,3,3)", "the admissible mesh has what the right column says"}};
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const std::string name = drawn[i].first == "levels" ? "levels of an admissible mesh" : drawn[i].first;
    rows.push_back({name, drawn[i].second ? "yes" : "no", correct[i].second ? "yes" : "no"});
  }
  return rows;
}

}  // namespace

void add_proof_perturbations(Paper& paper) {
  const ProofFigure drawn = drawn_proof_figure();
  const ProofFigure correct = correct_proof_figure();
  Checked drawn_mesh(drawn, drawn);
  Checked correct_mesh(correct, correct);
  const ProofSlice drawn_slice(drawn_mesh.mesh, drawn_mesh.margin());
  const ProofSlice correct_slice(correct_mesh.mesh, correct_mesh.margin());
  auto rows = texts_of(drawn);
  const auto correct_texts = texts_of(correct);
  std::string description = "Two slices of 17 x 21 unit squares with the perturbed regions.";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].push_back(correct_texts[i][1]);
    description += fmt::format(" {}: on the left {}, on the right {}.", rows[i][0], rows[i][1], rows[i][2]);
  }
  rows.push_back(
      {"x of Sigma; of the rest of Rx",
       fmt::format("no word; on the drawn levels {}; {}", drawn_slice.place(), drawn_slice.places_elsewhere()),
       fmt::format("{}; {}", correct_slice.place(), correct_slice.places_elsewhere())});
  rows.insert(rows.begin(), {"on the slice, y x z", "drawn in the paper", "on the admissible mesh, p = (3,3,3)"});
  Picture picture("Perturbed regions on the slice in the proof of Theorem 5.3, m = 2, K of level 3", description);
  const ProofPlane left(kPictureMargin, Picture::top(), kPixels);
  const ProofPlane right(left.frame.plot.upper[0] + px(40), Picture::top(), kPixels);
  draw_panel(picture.svg(), left, drawn_slice, drawn_regions(drawn), "as the paper draws it");
  draw_panel(picture.svg(), right, correct_slice, regions_of(correct_slice), "on the admissible mesh, p = (3,3,3)");
  const Px bottom =
      picture.add_legend(kPictureMargin, right.frame.plot.upper[1] + px(44),
                         {{region_colour(0), "dark area: Sigma, Rx on the slice; light: Rx at other x, seen along x"},
                          {region_colour(1), "lines at one y: Ry"},
                          {region_colour(2), "lines at one z: Rz"}});
  paper.files.push_back({"figure-proof-perturbations.svg", picture.finish(right.frame.plot.upper[0], bottom)});
  paper.tables["proof-perturbations"] = markdown_table(rows);
  paper.tables["proof-items"] = markdown_table(item_rows(drawn_mesh.items, correct_mesh.items));
}

}  // namespace asts
