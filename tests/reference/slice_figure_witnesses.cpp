#include <algorithm>

#include "tests/reference/skeleton_claims.hpp"
#include "tests/reference/skeleton_kinds.hpp"
#include "tests/reference/suitability.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

using Point2 = std::array<Rational, 2>;

/// One of the two figures after Definition 5.2: a grid of 4 x 5 unit squares, the line y = 3/2 from x = 0 to `end`, the
/// line x = 3/2 from y = 0 to 2; q = 3/2, p = 3. The outline of the blue supports has its corner at x = `corner`.
struct DrawnFigure {
  const char* name;
  int end, corner;
  Rational region_begin;  ///< Rx(q) is drawn from there to y = 4
  bool suitable;
};

const std::vector<DrawnFigure>& drawn_figures() {
  static const std::vector<DrawnFigure> figures{{"the first figure after Definition 5.2", 3, 2, Rational(3, 2), true},
                                                {"the second figure after Definition 5.2", 2, 1, 1, false}};
  return figures;
}

const DrawnFigure& figure_of(const json& name) {
  for (const DrawnFigure& figure : drawn_figures())
    if (name == figure.name) return figure;
  throw Rejected("figure: it is neither the first nor the second figure after Definition 5.2");
}

/// The grid is the active region: two unit squares around it, where lines that end on its sides run on; four layers.
/// The figure's point (x,y) is (x+2,y+2,2) here.
const Setting figure_setting{{3, 3, 3}, 2, {8, 9, 4}};

Mesh mesh_of_figure(const DrawnFigure& figure) {
  Mesh mesh;
  for (const Box& cube : initial_mesh(figure_setting)) {
    const bool across = cube.lower[1] == 3 && cube.lower[0] < figure.end + 2;  // y = 3/2 runs through it
    const bool along = cube.lower[0] == 3 && cube.lower[1] < 4;                // x = 3/2 does
    Mesh parts{cube};
    for (const std::size_t axis : {0U, 1U}) {
      if (!(axis == 0 ? along : across)) continue;
      Mesh halves;
      for (const Box& part : parts)
        for (const Box& half : subdivide_along(figure_setting, part, axis)) halves.push_back(half);
      parts = halves;
    }
    mesh.insert(mesh.end(), parts.begin(), parts.end());
  }
  return mesh;
}

bool is_integer(const Rational& x) { return denominator(x) == 1; }

/// Is the point of the figure drawn in the part?
bool is_drawn(const DrawnFigure& figure, const std::string& part, const Point2& t) {
  const auto& [x, y] = t;
  const Rational line(3, 2);
  if (part == "Nx(q)") {
    const bool on_grid = is_integer(x) && is_integer(y) && y <= 2;
    const bool on_vertical = x == line && is_integer(y) && y <= 2;
    const bool on_horizontal = y == line && (is_integer(x) || x == line) && x <= figure.end;
    return on_grid || on_vertical || on_horizontal;
  }
  if (part == "NA without Nx(q)") return is_integer(x) && is_integer(y) && y >= 3;
  if (part == "the union of supports of Nx(q)") return y <= 4;
  if (part == "the union of the other supports") return y >= line || (x >= figure.corner && y >= 1);
  if (part == "Rx(q)") return x == line && figure.region_begin <= y && y <= 4;
  if (part == "the classical extension") return x == line && line <= y && y <= 4;
  throw Rejected("part: the figure has no such part");
}

/// What the definitions give for the figure's mesh.
struct FigureFacts {
  Space<Rational> space;
  std::vector<ActiveNode<Rational>> splines;
  std::vector<Rectangle> rectangles;

  explicit FigureFacts(const DrawnFigure& figure) {
    const Mesh mesh = mesh_of_figure(figure);
    space = make_space<Rational>(figure_setting, mesh, 1);
    splines = active_splines(space).value();
    rectangles = planar_rectangles(mesh, 2).value();
  }

  bool in_slice(const ActiveNode<Rational>& v) const {
    return in_slice_nodes(space, 0, Rational(Rational(3, 2) + 2), v.node);
  }

  bool is_found(const std::string& part, const Point2& t) const {
    const Point point{t[0] + 2, t[1] + 2, 2};
    const bool in = part == "Nx(q)" || part == "the union of supports of Nx(q)";
    if (part == "Rx(q)") return t[0] == Rational(3, 2) && in_perturbed_region(space, splines, 0, point);
    if (part == "the classical extension") return in_extension(point);
    const bool nodes = part == "Nx(q)" || part == "NA without Nx(q)";
    return std::any_of(splines.begin(), splines.end(), [&](const ActiveNode<Rational>& v) {
      return in_slice(v) == in && (nodes ? v.node == point : in_closed(v.support, point));
    });
  }

  /// The extension of the vertical T-junction at (3/2,2).
  bool in_extension(const Point& point) const {
    const Point2 at{Rational(3, 2) + 2, 4};
    for (const PlanarJunction& junction : planar_junctions(rectangles)) {
      if (junction.point != at || junction.axis != 1) continue;
      const Rectangle segment = planar_extension(rectangles, junction, 3);
      return point[0] == at[0] && segment.lower[1] <= point[1] && point[1] <= segment.upper[1];
    }
    return false;
  }
};

Point2 read_figure_point(const json& value) {
  const std::vector<Rational> numbers = read_numbers(value);
  if (numbers.size() != 2) throw Rejected("point: it has not two coordinates");
  if (numbers[0] < 0 || 4 < numbers[0] || numbers[1] < 0 || 5 < numbers[1])
    throw Rejected("point: it is not in the grid");
  return {numbers[0], numbers[1]};
}

}  // namespace

std::string check_slice_figure(ClaimSubject& /*subject*/, const json& witness) {
  const json& values = values_of(witness, {"figure", "part", "point", "drawn"});
  const DrawnFigure& figure = figure_of(values["figure"]);
  if (!values["part"].is_string()) throw Rejected("part: it is no text");
  const std::string part = values["part"].get<std::string>();
  const Point2 t = read_figure_point(values["point"]);
  const bool drawn = is_drawn(figure, part, t);
  const std::string place = part + " in " + figure.name + " at (" + text(t[0]) + ", " + text(t[1]) + ")";
  if (FigureFacts(figure).is_found(part, t) == drawn)
    throw Rejected("nothing is violated: the definitions give what is drawn for " + place);
  if (values["drawn"] != (drawn ? "yes" : "no")) throw Rejected("drawn: it is not what is drawn");
  return "For " + place +
         (drawn ? ", the point is drawn, and the definitions do not give it."
                : ", the definitions give the point, and it is not drawn.");
}

std::string check_caption(ClaimSubject& /*subject*/, const json& witness) {
  const json& values = values_of(witness, {"figure", "caption"});
  const DrawnFigure& figure = figure_of(values["figure"]);
  if (values["caption"] != (figure.suitable ? "analysis-suitable" : "not analysis-suitable"))
    throw Rejected("caption: it says something else");
  const FigureFacts facts(figure);
  const bool suitable = analysis_suitable_by_rectangles(facts.space, facts.splines);
  const bool classically = !planar_extensions_meet(facts.rectangles, {3, 3});
  if (suitable == figure.suitable && classically == figure.suitable)
    throw Rejected("nothing is violated: the mesh is what the caption calls it");
  return std::string("The mesh of ") + figure.name + " is " + (suitable ? "" : "not ") +
         "analysis-suitable by Definition 5.2 and " + (classically ? "" : "not ") + "so in the classical sense.";
}

}  // namespace asts::reference
