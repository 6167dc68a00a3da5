#include "properties/claims/slice_figures.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "lib/gen/planar_tiling.hpp"
#include "lib/spline/hanging.hpp"
#include "lib/spline/perturbed_regions.hpp"
#include "properties/claims/planar_suitability.hpp"

namespace asts {

namespace {

using Node = SliceFigure::Node;

constexpr PerAxis<int> kDegree{3, 3, 3};
constexpr int kFrame = 2;     // ceil(p/2)
constexpr Node kSize{8, 10};  // the drawn grid, in halves
constexpr int kSlice = 3;     // q = 3/2

Case mesh_of_figure(const SliceFigure& figure) {
  PlanarTiling tiling({kSize[0] / 2, kSize[1] / 2}, 2);
  for (const SliceFigure::Line& line : figure.lines) tiling.cut_line(line.axis, line.place, line.begin, line.end);
  return tiling.extruded(kDegree);
}

Rational in_mesh(int halves) { return Rational(halves) / 2 + kFrame; }

/// The drawn coordinate of a line of the mesh, in halves.
Rational drawn(const Mesh& mesh, Axis axis, std::int32_t rank) {
  return Rational((mesh.coordinate(axis, rank) - kFrame) * 2);
}

/// A set in the drawn part, as its points at multiples of a quarter of a unit: enough to tell closed sets apart whose
/// sides are at halves. In quarters.
using Quarters = std::set<Node>;

void add_rectangle(const std::array<Rational, 2>& lower, const std::array<Rational, 2>& upper, Quarters& set) {
  for (int x = 0; x <= 2 * kSize[0]; ++x) {
    for (int y = 0; y <= 2 * kSize[1]; ++y) {
      if (2 * lower[0] <= x && x <= 2 * upper[0] && 2 * lower[1] <= y && y <= 2 * upper[1]) set.insert({x, y});
    }
  }
}

Quarters union_of(const std::vector<SliceFigure::Rectangle>& rectangles) {
  Quarters set;
  for (const SliceFigure::Rectangle& rectangle : rectangles) {
    add_rectangle({rectangle.lower[0], rectangle.lower[1]}, {rectangle.upper[0], rectangle.upper[1]}, set);
  }
  return set;
}

Quarters segment(const std::array<int, 2>& range) { return union_of({{{kSlice, range[0]}, {kSlice, range[1]}}}); }

/// What the definitions give for the figure's mesh.
struct SliceFacts {
  std::set<std::array<Rational, 2>> nodes_in;
  std::set<std::array<Rational, 2>> nodes_out;
  Quarters support_in;
  Quarters support_out;
  Quarters perturbation;
};

void add_node(MeshUnderTest& mesh, std::int32_t node, SliceFacts& facts) {
  const Mesh& boxes = mesh.mesh();
  const TSplines& splines = mesh.splines();
  PerAxis<HalfRank> projection;
  for (std::size_t axis = 0; axis < kDimension; ++axis) projection[axis] = 2 * splines.nodes[at(node)][axis];
  projection[0] = half_rank(boxes, 0, in_mesh(kSlice));
  const bool in = in_skeleton(boxes, 0, projection);
  std::array<Rational, 2> position;
  std::array<Rational, 2> lower;
  std::array<Rational, 2> upper;
  for (Axis axis = 0; axis < 2; ++axis) {
    position[at(axis)] = drawn(boxes, axis, splines.nodes[at(node)][at(axis)]);
    lower[at(axis)] = drawn(boxes, axis, splines.support(node, axis).lower);
    upper[at(axis)] = drawn(boxes, axis, splines.support(node, axis).upper);
  }
  (in ? facts.nodes_in : facts.nodes_out).insert(position);
  add_rectangle(lower, upper, in ? facts.support_in : facts.support_out);
}

void add_perturbation(MeshUnderTest& mesh, SliceFacts& facts) {
  const HalfRank slice = half_rank(mesh.mesh(), 0, in_mesh(kSlice));
  for (int y = 0; y <= 2 * kSize[1]; ++y) {
    const HalfRank position = half_rank(mesh.mesh(), 1, Rational(y) / 4 + kFrame);
    for (const Box& part : perturbed_region(mesh.splines(), mesh.bricks(), 0)) {
      const bool inside = part.lower[0] == slice && part.lower[1] <= position && position <= part.upper[1];
      if (inside) facts.perturbation.insert({2 * kSlice, y});
    }
  }
}

SliceFacts facts_of(MeshUnderTest& mesh) {
  SliceFacts facts;
  for (std::int32_t node = 0; node < mesh.splines().size(); ++node) add_node(mesh, node, facts);
  add_perturbation(mesh, facts);
  return facts;
}

std::set<std::array<Rational, 2>> as_rationals(const std::vector<Node>& nodes) {
  std::set<std::array<Rational, 2>> result;
  for (const Node& node : nodes) result.insert({Rational(node[0]), Rational(node[1])});
  return result;
}

/// The T-junction extension at the point (3/2, 2) by the classical definition.
Quarters classical_extension(MeshUnderTest& mesh) {
  const Mesh& boxes = mesh.mesh();
  const PlanarMesh planar = planar_mesh(boxes).value();
  for (const TJunction& junction : t_junctions(planar.edges)) {
    if (drawn(boxes, 0, junction.position[0]) != kSlice || drawn(boxes, 1, junction.position[1]) != 4) continue;
    const Extension found = extension(planar.edges, junction, kDegree[1]);
    Quarters set;
    add_rectangle({kSlice, drawn(boxes, 1, found.lower)}, {kSlice, drawn(boxes, 1, found.upper)}, set);
    return set;
  }
  return {};
}

bool suitable_both_ways(MeshUnderTest& mesh, bool expected) {
  const bool regions_meet = find_meeting_regions(mesh.splines(), mesh.bricks()).has_value();
  const bool extensions_meet =
      crossing_extensions(planar_mesh(mesh.mesh())->edges, {kDegree[0], kDegree[1]}).has_value();
  return regions_meet != expected && extensions_meet != expected;
}

/// A point of the figure that only one of two sets has.
struct Difference {
  std::vector<Rational> point;  ///< in units of the figure
  bool drawn;                   ///< else found
};

/// The least one. `parts`: how many units of the sets make one of the figure.
template <class Set>
std::optional<Difference> difference(const Set& drawn, const Set& found, int parts) {
  std::optional<Difference> result;
  const auto look = [&](const Set& one, const Set& other, bool is_drawn) {
    for (const auto& [x, y] : one) {
      if (result || other.contains({x, y})) continue;
      result = Difference{{Rational(x) / parts, Rational(y) / parts}, is_drawn};
    }
  };
  look(drawn, found, true);
  look(found, drawn, false);
  return result;
}

struct Comparison {
  const char* part;
  std::optional<Difference> difference;
};

std::vector<Comparison> compare(const SliceFigure& figure, MeshUnderTest& mesh) {
  const SliceFacts facts = facts_of(mesh);
  return {{"Nx(q)", difference(as_rationals(figure.nodes_in), facts.nodes_in, 2)},
          {"NA without Nx(q)", difference(as_rationals(figure.nodes_out), facts.nodes_out, 2)},
          {"the union of supports of Nx(q)", difference(union_of(figure.support_in), facts.support_in, 4)},
          {"the union of the other supports", difference(union_of(figure.support_out), facts.support_out, 4)},
          {"Rx(q)", difference(segment(figure.perturbation), facts.perturbation, 4)},
          {"the classical extension", difference(segment(figure.extension), classical_extension(mesh), 4)}};
}

Verdict drawn_otherwise(const SliceFigure& figure, const Comparison& comparison) {
  return Verdict::violated(
      ClaimWitness{"drawn-otherwise",
                   "the point belongs to the part as it is drawn or as the definitions have it, but not to both",
                   {{"figure", std::string(figure.name)},
                    {"part", std::string(comparison.part)},
                    {"point", comparison.difference->point},
                    {"drawn", std::string(comparison.difference->drawn ? "yes" : "no")}}});
}

Verdict caption_disagrees(const SliceFigure& figure) {
  return Verdict::violated(
      ClaimWitness{"caption-disagrees",
                   "the mesh is not what the caption calls it",
                   {{"figure", std::string(figure.name)},
                    {"caption", std::string(figure.suitable ? "analysis-suitable" : "not analysis-suitable")}}});
}

}  // namespace

Trial judge_slice_figure(const SliceFigure& figure) {
  const Case content = mesh_of_figure(figure);
  MeshUnderTest mesh(mesh_of(setting_of(content), content.elements));
  const std::vector<Comparison> comparisons = compare(figure, mesh);
  Trial trial{{}, static_cast<std::int64_t>(figure.nodes_in.size() + figure.nodes_out.size() + comparisons.size() - 1)};
  for (const Comparison& comparison : comparisons) {
    if (!comparison.difference) continue;
    trial.verdict = drawn_otherwise(figure, comparison);
    return trial;
  }
  if (!suitable_both_ways(mesh, figure.suitable)) trial.verdict = caption_disagrees(figure);
  return trial;
}

namespace {

/// The grid's nodes in some rows.
std::vector<Node> grid_rows(int first, int last) {
  std::vector<Node> nodes;
  for (int x = 0; x <= 4; ++x) {
    for (int y = first; y <= last; ++y) nodes.push_back({2 * x, 2 * y});
  }
  return nodes;
}

/// The orange nodes: rows 0, 1, 2, those on the line x = 3/2, and those on y = 3/2 at the given places.
std::vector<Node> orange_nodes(const std::vector<int>& on_line) {
  std::vector<Node> nodes = grid_rows(0, 2);
  for (const int y : {0, 2, 4}) nodes.push_back({3, y});
  for (const int x : on_line) nodes.push_back({x, 3});
  return nodes;
}

}  // namespace

std::vector<SliceFigure> slice_figures() {
  // The outlines are drawn a little apart from one another; those that run outside the grid mean everything there.
  return {{"the first figure after Definition 5.2",
           {{1, 3, 0, 6}, {0, 3, 0, 4}},
           orange_nodes({0, 2, 3, 4, 6}),
           grid_rows(3, 5),
           {{{0, 0}, {8, 8}}},
           {{{0, 3}, {8, 10}}, {{4, 2}, {8, 10}}},
           {3, 8},
           {3, 8},
           true},
          {"the second figure after Definition 5.2",
           {{1, 3, 0, 4}, {0, 3, 0, 4}},
           orange_nodes({0, 2, 3, 4}),
           grid_rows(3, 5),
           {{{0, 0}, {8, 8}}},
           {{{0, 3}, {8, 10}}, {{2, 2}, {8, 10}}},
           {2, 8},
           {3, 8},
           false}};
}

Trial figure_slices_alone(Extent /*extent*/) {
  Trial total;
  for (const SliceFigure& figure : slice_figures()) {
    const Trial trial = judge_slice_figure(figure);
    total.met += trial.met;
    if (trial.verdict.outcome == Outcome::violated) total.verdict = trial.verdict;
  }
  return total;
}

}  // namespace asts
