#include <fmt/format.h>

#include <algorithm>

#include "lib/exact/errors.hpp"
#include "properties/claims/slice_figures.hpp"
#include "reports/paper/paper.hpp"
#include "reports/slice_svg.hpp"

namespace asts {

namespace {

/// The drawn part is the active region, which begins at (2,2); q = 3/2 as drawn.
constexpr int kFrame = 2;
const Rational kSlice = Rational(3, 2) + kFrame;

/// The y-range of R_x(q) as drawn: from the lowest to the highest segment in x = q. REQUIRES: there is one.
std::string perturbation(const SliceGeometry& geometry) {
  std::optional<std::pair<Rational, Rational>> range;
  for (const PlaneRectangle& part : geometry.regions.value()[0]) {
    if (part.lower[0] != kSlice || part.upper[0] != kSlice) continue;
    if (!range) range = {part.lower[1], part.upper[1]};
    range = {std::min(range->first, part.lower[1]), std::max(range->second, part.upper[1])};
  }
  ensure(range.has_value(), "the planar examples have a slice perturbation");
  return fmt::format("[{},{}]", to_string(Rational(range->first - kFrame)),
                     to_string(Rational(range->second - kFrame)));
}

std::string halves(const std::array<int, 2>& range) {
  return fmt::format("[{},{}]", to_string(Rational(range[0], 2)), to_string(Rational(range[1], 2)));
}

std::vector<std::string> row_of(const SliceFigure& figure, const SliceGeometry& geometry, MeshUnderTest& mesh) {
  const bool suitable = !mesh.meeting_regions().has_value();
  const Trial everything = judge_slice_figure(figure);
  return {figure.suitable ? "first" : "second",
          std::to_string(figure.nodes_in.size()),
          std::to_string(figure.nodes_out.size()),
          halves(figure.perturbation),
          perturbation(geometry),
          halves(figure.extension),
          figure.suitable ? "yes" : "no",
          suitable ? "yes" : "no",
          everything.verdict.outcome == Outcome::holds ? "yes" : "no"};
}

}  // namespace

void add_planar_examples(const PaperCases& cases, Paper& paper) {
  std::vector<std::vector<std::string>> rows{{"figure", "nodes in N_x(q), drawn", "other nodes, drawn",
                                              "R_x(q) in y, drawn", "R_x(q) in y, here",
                                              "T-junction extension in y, drawn", "analysis-suitable, caption",
                                              "analysis-suitable, here", "all nodes and sets as drawn"}};
  for (const SliceFigure& figure : slice_figures()) {
    const Case& example = figure.suitable ? cases.planar_suitable : cases.planar_unsuitable;
    MeshUnderTest mesh(mesh_of(setting_of(example), example.elements));
    const Slice slice{2, kFrame};
    rows.push_back(row_of(figure, cut(mesh, slice), mesh));
    const std::string name = figure.suitable ? "figure-planar-suitable.svg" : "figure-planar-unsuitable.svg";
    paper.files.push_back({name, slice_svg(mesh, slice, {})});
  }
  paper.tables["planar"] = markdown_table(rows);
}

}  // namespace asts
