#include "properties/claims/planar_suitability.hpp"

#include <algorithm>

#include "lib/gen/planar_tiling.hpp"
#include "lib/spline/perturbed_regions.hpp"
#include "properties/describe.hpp"
#include "properties/splines_needed.hpp"

namespace asts {

namespace {

std::int32_t line_count(const Mesh& mesh, Axis axis) {
  return static_cast<std::int32_t>(mesh.coordinates[at(axis)].size());
}

bool in_one_unit(const Rational& lower, const Rational& upper) {
  const Rational unit(boost::multiprecision::numerator(lower) / boost::multiprecision::denominator(lower));
  return upper <= unit + 1;
}

/// The closed segment of an extension, on the lower side of the domain along the axis of extrusion.
ExactBox segment_of(const Mesh& mesh, Axis extruded, const Extension& extension) {
  const auto axes = planar_axes(extruded);
  const Axis along = axes[extension.junction.axis];
  const Axis across = axes[1 - extension.junction.axis];
  ExactBox segment;
  segment.lower[at(along)] = mesh.coordinate(along, extension.lower);
  segment.upper[at(along)] = mesh.coordinate(along, extension.upper);
  segment.lower[at(across)] = segment.upper[at(across)] = mesh.coordinate(across, extension.line());
  return segment;
}

ExactPoint junction_point(const Mesh& mesh, Axis extruded, const TJunction& junction) {
  ExactPoint point;
  const auto axes = planar_axes(extruded);
  for (std::size_t i = 0; i < 2; ++i) point[at(axes[i])] = mesh.coordinate(axes[i], junction.position[i]);
  return point;
}

Verdict only_extensions_meet(const Mesh& mesh, Axis extruded, const std::pair<Extension, Extension>& meeting) {
  return Verdict::violated(
      ClaimWitness{"only-extensions-meet",
                   "a horizontal and a vertical T-junction extension meet, but no two perturbed regions do",
                   {{"extruded_along", std::string(axis_name(extruded))},
                    {"horizontal_junction", junction_point(mesh, extruded, meeting.first.junction)},
                    {"horizontal_extension", segment_of(mesh, extruded, meeting.first)},
                    {"vertical_junction", junction_point(mesh, extruded, meeting.second.junction)},
                    {"vertical_extension", segment_of(mesh, extruded, meeting.second)}}});
}

Verdict only_regions_meet(MeshUnderTest& mesh, Axis extruded, const RegionsMeet& meeting) {
  ExactPoint point;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    point[at(axis)] = coordinate_of(mesh.mesh(), axis, meeting.point[at(axis)]);
  }
  return Verdict::violated(ClaimWitness{
      "only-regions-meet",
      "two perturbed regions meet in the point, but no horizontal T-junction extension meets a vertical one",
      {{"extruded_along", std::string(axis_name(extruded))},
       {"point", point},
       {"first", std::string(axis_name(meeting.first_axis))},
       {"second", std::string(axis_name(meeting.second_axis))}}});
}

std::array<int, 2> planar_degree(const Mesh& mesh, Axis extruded) {
  const auto axes = planar_axes(extruded);
  return {mesh.setting.degree[at(axes[0])], mesh.setting.degree[at(axes[1])]};
}

/// Why the remark says nothing about a mesh.
std::optional<Verdict> outside_remark(MeshUnderTest& mesh, const std::optional<PlanarMesh>& planar) {
  if (!planar) return Verdict::not_applicable("the mesh is not planar");
  if (!refines_unit_squares(mesh.mesh(), planar->extruded)) {
    return Verdict::not_applicable("the planar mesh is no refinement of the unit squares");
  }
  if (!lines_end_inside(mesh.mesh(), *planar)) {
    return Verdict::not_applicable("a line ends outside the interior of the active region");
  }
  return lacks_splines(mesh);
}

}  // namespace

std::optional<PlanarMesh> planar_mesh(const Mesh& mesh) {
  for (Axis extruded = kDimension - 1; extruded >= 0; --extruded) {
    if (auto boxes = planar_boxes(mesh, extruded)) {
      const auto axes = planar_axes(extruded);
      PlanarEdges edges({line_count(mesh, axes[0]), line_count(mesh, axes[1])}, *boxes);
      return PlanarMesh{extruded, std::move(*boxes), std::move(edges)};
    }
  }
  return std::nullopt;
}

bool refines_unit_squares(const Mesh& mesh, Axis extruded) {
  const auto axes = planar_axes(extruded);
  return std::all_of(mesh.elements.begin(), mesh.elements.end(), [&](const Box& element) {
    return std::all_of(axes.begin(), axes.end(), [&](Axis axis) {
      return in_one_unit(mesh.coordinate(axis, element.lower[at(axis)]),
                         mesh.coordinate(axis, element.upper[at(axis)]));
    });
  });
}

bool lines_end_inside(const Mesh& mesh, const PlanarMesh& planar) {
  const auto axes = planar_axes(planar.extruded);
  const ActiveRegion active = active_region(mesh);
  const std::vector<TJunction> junctions = t_junctions(planar.edges);
  return std::all_of(junctions.begin(), junctions.end(), [&](const TJunction& junction) {
    for (std::size_t i = 0; i < 2; ++i) {
      const HalfRank position = 2 * junction.position[i];
      if (position <= active.lower[at(axes[i])] || position >= active.upper[at(axes[i])]) return false;
    }
    return true;
  });
}

Trial judge_planar(MeshUnderTest& mesh, const PlanarMesh& planar, const std::array<int, 2>& extension_degree) {
  const std::vector<TJunction> junctions = t_junctions(planar.edges);
  const std::int64_t horizontal =
      std::count_if(junctions.begin(), junctions.end(), [](const TJunction& junction) { return junction.axis == 0; });
  Trial trial{{}, horizontal * (static_cast<std::int64_t>(junctions.size()) - horizontal)};
  const auto extensions = crossing_extensions(planar.edges, extension_degree);
  const auto regions = find_meeting_regions(mesh.splines(), mesh.bricks());
  if (extensions && !regions) trial.verdict = only_extensions_meet(mesh.mesh(), planar.extruded, *extensions);
  if (regions && !extensions) trial.verdict = only_regions_meet(mesh, planar.extruded, *regions);
  return trial;
}

Trial planar_equals_classical(MeshUnderTest& mesh) {
  const std::optional<PlanarMesh> planar = planar_mesh(mesh.mesh());
  if (const auto verdict = outside_remark(mesh, planar)) return {*verdict};
  return judge_planar(mesh, *planar, planar_degree(mesh.mesh(), planar->extruded));
}

Trial planar_equals_classical_repaired(MeshUnderTest& mesh) {
  const std::optional<PlanarMesh> planar = planar_mesh(mesh.mesh());
  if (const auto verdict = outside_remark(mesh, planar)) return {*verdict};
  if (facing_junctions(planar->edges)) return {Verdict::not_applicable("two T-junctions face each other")};
  return judge_planar(mesh, *planar, planar_degree(mesh.mesh(), planar->extruded));
}

namespace {

/// Adds a planar mesh's trial; false at a violation.
bool add_planar_trial(const PlanarTiling& tiling, const PerAxis<int>& degree, Trial& total) {
  const Case extruded = tiling.extruded(degree);
  MeshUnderTest mesh(mesh_of(setting_of(extruded), extruded.elements));
  const Trial trial = planar_equals_classical_repaired(mesh);
  total.met += trial.met;
  if (trial.verdict.outcome == Outcome::violated) total.verdict = trial.verdict;
  return trial.verdict.outcome != Outcome::violated;
}

bool try_all_halved(std::array<int, 2> squares, Trial& total) {
  std::vector<int> ways(static_cast<std::size_t>(squares[0] * squares[1]), 0);
  while (true) {
    if (!add_planar_trial(halved_squares(squares, ways), {3, 3, 3}, total)) return false;
    std::size_t place = 0;
    while (place < ways.size() && ways[place] == kSquareCuts - 1) ways[place++] = 0;
    if (place == ways.size()) return true;
    ++ways[place];
  }
}

bool try_random(int count, Trial& total) {
  Draw draw(1);
  for (int i = 0; i < count; ++i) {
    const PerAxis<int> degree{2 * draw.between(1, 3) + 1, 2 * draw.between(1, 3) + 1, 3};
    const std::array<int, 2> squares{draw.between(1, 6), draw.between(1, 6)};
    if (!add_planar_trial(random_planar_tiling(draw, squares), degree, total)) return false;
  }
  return true;
}

}  // namespace

Trial planar_equals_classical_repaired_alone(Extent extent) {
  const bool long_run = extent == Extent::long_run;
  Trial total;
  if (!try_all_halved({1, 1}, total) || !try_all_halved({1, 2}, total) || !try_all_halved({2, 1}, total)) return total;
  if (long_run && !try_all_halved({2, 2}, total)) return total;
  try_random(long_run ? 50'000 : 1'000, total);
  return total;
}

}  // namespace asts
