#include <algorithm>

#include "tests/reference/skeleton_claims.hpp"
#include "tests/reference/skeleton_kinds.hpp"
#include "tests/reference/spline_hypotheses.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

/// A planar mesh for which the remark is made, seen along the axis of extrusion.
struct PlanarSubject {
  std::size_t axis;
  std::array<std::size_t, 2> axes;  ///< horizontal, vertical
  std::vector<Rectangle> rectangles;
  std::array<int, 2> degree;
  std::string hypotheses;
};

bool in_one_unit(const Rational& lower, const Rational& upper, int length) {
  for (int i = 0; i < length; ++i)
    if (i <= lower && upper <= i + 1) return true;
  return false;
}

void require_remark(const Setting& setting, const PlanarSubject& planar, bool facing_allowed) {
  for (const Rectangle& k : planar.rectangles)
    for (std::size_t i = 0; i < 2; ++i)
      if (!in_one_unit(k.lower[i], k.upper[i], setting.domain[planar.axes[i]]))
        throw Rejected("the planar mesh is no refinement of the unit squares: the claim says nothing about it");
  for (const PlanarJunction& junction : planar_junctions(planar.rectangles))
    for (std::size_t i = 0; i < 2; ++i) {
      const int half = (planar.degree[i] + 1) / 2;
      if (junction.point[i] <= half || setting.domain[planar.axes[i]] - half <= junction.point[i])
        throw Rejected("a line ends outside the interior of the active region: the claim says nothing about the mesh");
    }
  if (!facing_allowed && planar_junctions_face(planar.rectangles))
    throw Rejected("two T-junctions face each other across one element: the claim says nothing about the mesh");
}

PlanarSubject read_planar(ClaimSubject& subject, const json& axis_value, bool facing_allowed) {
  const std::size_t axis = read_axis(axis_value);
  const auto rectangles = planar_rectangles(subject.mesh(), axis);
  if (!rectangles) throw Rejected(std::string("the mesh is not extruded along ") + axis_name(axis));
  const std::array<std::size_t, 2> axes{axis == 0 ? 1U : 0U, axis == 2 ? 1U : 2U};
  const std::array<int, dimension>& p = subject.setting().degree;
  PlanarSubject result{axis, axes, *rectangles, {p[axes[0]], p[axes[1]]}, {}};
  require_remark(subject.setting(), result, facing_allowed);
  result.hypotheses = std::string("Hypotheses: the mesh is planar, extruded along ") + axis_name(axis) +
                      ", refines the unit squares, and no line ends outside the interior of the active region" +
                      (facing_allowed ? "." : "; no two T-junctions face each other.");
  result.hypotheses += splines_exist(subject.setting(), subject.mesh());
  return result;
}

/// The extension that a witness names with its junction. `along`: 0 for horizontal ones.
Rectangle read_extension(const PlanarSubject& planar, const json& junction, const json& extension, std::size_t along) {
  const char* name = along == 0 ? "horizontal" : "vertical";
  const Point point = read_point(junction);
  const Box box = read_box(extension, std::string(name) + "_extension");
  if (point[planar.axis] != 0 || box.lower[planar.axis] != 0 || box.upper[planar.axis] != 0)
    throw Rejected(std::string(name) + ": a coordinate along the axis of extrusion is not written as 0");
  bool is_junction = false;
  for (const PlanarJunction& known : planar_junctions(planar.rectangles)) {
    if (known.axis != along || known.point[0] != point[planar.axes[0]] || known.point[1] != point[planar.axes[1]])
      continue;
    is_junction = true;
    const Rectangle actual = planar_extension(planar.rectangles, known, planar.degree[along]);
    bool same = true;
    for (std::size_t i = 0; i < 2; ++i)
      same = same && actual.lower[i] == box.lower[planar.axes[i]] && actual.upper[i] == box.upper[planar.axes[i]];
    if (same) return actual;
  }
  throw Rejected(std::string(name) + (is_junction
                                          ? "_extension is not that of the junction"
                                          : "_junction is no T-junction whose missing edge is " + std::string(name)));
}

std::string text_of(const Rectangle& k) {
  return "[" + text(k.lower[0]) + ", " + text(k.upper[0]) + "] x [" + text(k.lower[1]) + ", " + text(k.upper[1]) + "]";
}

std::string check_extensions(ClaimSubject& subject, const json& witness, bool facing_allowed) {
  const json& values = values_of(witness, {"extruded_along", "horizontal_junction", "horizontal_extension",
                                           "vertical_junction", "vertical_extension"});
  const PlanarSubject planar = read_planar(subject, values["extruded_along"], facing_allowed);
  const Rectangle h = read_extension(planar, values["horizontal_junction"], values["horizontal_extension"], 0);
  const Rectangle v = read_extension(planar, values["vertical_junction"], values["vertical_extension"], 1);
  for (std::size_t i = 0; i < 2; ++i)
    if (h.upper[i] < v.lower[i] || v.upper[i] < h.lower[i]) throw Rejected("the two extensions do not meet");
  const std::string suitable = mesh_is_suitable(subject.setting(), subject.mesh());
  return planar.hypotheses + " Conclusion: the extensions " + text_of(h) + " and " + text_of(v) +
         " meet, so that the mesh is not analysis-suitable in the classical sense, but:" + suitable;
}

std::string check_regions(ClaimSubject& subject, const json& witness, bool facing_allowed) {
  const json& values = values_of(witness, {"extruded_along", "point", "first", "second"});
  const PlanarSubject planar = read_planar(subject, values["extruded_along"], facing_allowed);
  const Space<Rational> space = make_space<Rational>(subject.setting(), subject.mesh(), 1);
  const auto splines = active_splines(space);
  const Point t = read_point(values["point"]);
  const std::size_t first = read_axis(values["first"]), second = read_axis(values["second"]);
  if (first == second) throw Rejected("both perturbed regions are of the same axis");
  for (const std::size_t axis : {first, second})
    if (!in_perturbed_region(space, *splines, axis, t)) throw Rejected(text(t) + " is not in R_" + axis_name(axis));
  if (planar_extensions_meet(planar.rectangles, planar.degree))
    throw Rejected("nothing is violated: a horizontal and a vertical T-junction extension meet");
  return planar.hypotheses + " Conclusion: " + text(t) + " is in R_" + axis_name(first) + " and in R_" +
         axis_name(second) +
         ", so that the mesh is not analysis-suitable by Definition 5.2, but no horizontal extension " +
         "meets a vertical one.";
}

}  // namespace

std::string check_only_extensions_meet(ClaimSubject& subject, const json& witness) {
  return check_extensions(subject, witness, true);
}
std::string check_only_extensions_meet_repaired(ClaimSubject& subject, const json& witness) {
  return check_extensions(subject, witness, false);
}
std::string check_only_regions_meet(ClaimSubject& subject, const json& witness) {
  return check_regions(subject, witness, true);
}
std::string check_only_regions_meet_repaired(ClaimSubject& subject, const json& witness) {
  return check_regions(subject, witness, false);
}

}  // namespace asts::reference
