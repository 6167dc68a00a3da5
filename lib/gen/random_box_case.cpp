#include <algorithm>

#include "lib/gen/biased_cases.hpp"
#include "lib/gen/random_boxes.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/refine/replay.hpp"

namespace asts {

namespace {

ElementLine as_line(const RationalBox& box) {
  ElementLine line;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    line.lower[axis] = CompactRational(box.lower[axis]);
    line.upper[axis] = CompactRational(box.upper[axis]);
  }
  return line;
}

RationalBox as_box(const Mesh& mesh, const Box& element) {
  RationalBox box;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    box.lower[a] = mesh.coordinate(axis, element.lower[a]);
    box.upper[a] = mesh.coordinate(axis, element.upper[a]);
  }
  return box;
}

Case explicit_case(Draw& draw, const Setting& setting, std::vector<RationalBox> boxes) {
  draw.shuffle(boxes);
  Case result{setting.degree, setting.grading, setting.domain, {}, true, {}};
  for (const RationalBox& box : boxes) result.elements.push_back(as_line(box));
  return result;
}

/// What an operation on a tiling needs to know.
struct Work {
  Draw& draw;
  const Setting& setting;
  BoxTiling& tiling;
  std::size_t axis;  ///< of extrusion, where there is one
};

/// Stretches a region to an end of the domain, along some axes: a cut across it ends on one side only, as T-junctions
/// do that face each other.
void stretch(const Work& work, RationalBox& region) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (work.draw.one_in(2)) continue;
    if (work.draw.one_in(2)) {
      region.lower[axis] = 0;
    } else {
      region.upper[axis] = work.setting.domain[axis];
    }
  }
}

/// A plane across a region.
void cut_somewhere(const Work& work) {
  RationalBox region = random_region(work.draw, work.tiling, work.setting, 1);
  const std::size_t axis = work.draw.index(kDimension);
  const Rational q = random_between(work.draw, region.lower[axis], region.upper[axis]);
  stretch(work, region);
  work.tiling.cut(axis, q, region);
}

/// The same across the planar mesh: the region has all of the extrusion's axis, and the plane is along that axis.
void cut_planar(const Work& work) {
  RationalBox region = random_region(work.draw, work.tiling, work.setting, 1);
  const std::size_t axis = (work.axis + 1 + work.draw.index(kDimension - 1)) % kDimension;
  const Rational q = random_between(work.draw, region.lower[axis], region.upper[axis]);
  stretch(work, region);
  region.lower[work.axis] = 0;
  region.upper[work.axis] = work.setting.domain[work.axis];
  work.tiling.cut(axis, q, region);
}

void merge_somewhere(const Work& work) {
  const RationalBox region = random_region(work.draw, work.tiling, work.setting, 2);
  work.tiling.replace(region, {region});
}

bool in_frame(const Setting& setting, const RationalBox& box) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const int frame = (setting.degree[axis] + 1) / 2;
    if (box.upper[axis] <= frame || box.lower[axis] >= setting.domain[axis] - frame) return true;
  }
  return false;
}

void merge_in_frame(const Work& work) {
  const RationalBox region = random_region(work.draw, work.tiling, work.setting, 3);
  if (in_frame(work.setting, region)) work.tiling.replace(region, {region});
}

void place_pinwheel(const Work& work) {
  const RationalBox region = random_region(work.draw, work.tiling, work.setting, 2);
  work.tiling.replace(region, pinwheel(work.draw, region, work.draw.index(kDimension)));
}

void operate(Bias bias, const Work& work) {
  switch (bias) {
    case Bias::boxes_merged:
      return merge_somewhere(work);
    case Bias::boxes_frame:
      return merge_in_frame(work);
    case Bias::boxes_pinwheel:
      return place_pinwheel(work);
    case Bias::boxes_planar:
      return cut_planar(work);
    default:
      return cut_somewhere(work);
  }
}

/// The last mesh of a case as boxes.
Case written_out(Draw& draw, const Case& steps) {
  Replay replay(steps);
  while (!replay.done()) replay.advance();
  const Mesh mesh = mesh_of(replay.tree());
  std::vector<RationalBox> boxes;
  for (const Box& element : mesh.elements) boxes.push_back(as_box(mesh, element));
  return explicit_case(draw, mesh.setting, std::move(boxes));
}

/// A planar mesh has its active region as thin as it gets along the axis of extrusion, and room for more across.
Setting planar_setting(Draw& draw, const CaseLimits& limits, std::size_t axis) {
  Setting setting = random_setting(draw, limits);
  setting.domain[axis] = setting.degree[axis] + 1;
  return setting;
}

Case worked_on(Draw& draw, const Setting& setting, const CaseLimits& limits, Bias bias, std::size_t extruded) {
  BoxTiling tiling(setting, draw, bias != Bias::boxes_planar && draw.one_in(3));
  const Work work{draw, setting, tiling, extruded};
  for (int operations = draw.between(1, limits.max_steps); operations > 0; --operations) {
    const BoxTiling before = tiling;
    operate(bias, work);
    if (static_cast<std::int64_t>(tiling.boxes().size()) <= limits.max_elements) continue;
    tiling = before;
    break;
  }
  return explicit_case(draw, setting, tiling.boxes());
}

/// An axis along which the active region is as thin as it gets, if there is one.
std::size_t thin_axis(Draw& draw, const Setting& setting) {
  std::vector<std::size_t> thin;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (setting.domain[axis] == setting.degree[axis] + 1) thin.push_back(axis);
  }
  return thin.empty() ? draw.index(kDimension) : draw.choose(thin);
}

/// A cut along a whole line of the planar mesh, or one with an end or two in the interior of the active region, at
/// integers.
void cut_inside(const Work& work) {
  const Setting& setting = work.setting;
  const std::size_t across = (work.axis + 1 + work.draw.index(kDimension - 1)) % kDimension;
  const std::size_t along = kDimension - work.axis - across;
  RationalBox region;
  for (std::size_t axis = 0; axis < kDimension; ++axis) region.upper[axis] = setting.domain[axis];
  const auto frame = [&](std::size_t axis) { return (setting.degree[axis] + 1) / 2; };
  int first_cell = 0;
  if (const int first = frame(along) + 1, last = setting.domain[along] - first; first <= last && !work.draw.one_in(4)) {
    const int end = work.draw.between(first, last);
    (work.draw.one_in(2) ? region.lower : region.upper)[along] = end;
    if (end < last && region.lower[along] == end && work.draw.one_in(3)) region.upper[along] = last;
    first_cell = frame(across);
  }
  const int cell = work.draw.between(first_cell, setting.domain[across] - 1 - first_cell);
  work.tiling.cut(across, random_between(work.draw, cell, cell + 1), region);
}

}  // namespace

RandomCase planar_inside_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits) {
  BoxTiling tiling(setting, draw, false);
  const Work work{draw, setting, tiling, thin_axis(draw, setting)};
  for (int cuts = draw.between(2, std::max(2, std::min(limits.max_steps, 6))); cuts > 0; --cuts) cut_inside(work);
  return {explicit_case(draw, setting, tiling.boxes()), Bias::boxes_planar_inside};
}

RandomCase random_box_case(Draw& draw, const CaseLimits& limits) {
  const Bias bias = draw.choose(std::vector{Bias::boxes_cut, Bias::boxes_merged, Bias::boxes_frame,
                                            Bias::boxes_pinwheel, Bias::boxes_planar, Bias::boxes_written_out});
  if (bias == Bias::boxes_written_out) {
    const RandomCase steps = draw.one_in(2) ? random_admissible_case(draw, limits) : random_bare_case(draw, limits);
    return {written_out(draw, steps.content), bias};
  }
  const std::size_t extruded = draw.index(kDimension);
  const Setting setting =
      bias == Bias::boxes_planar ? planar_setting(draw, limits, extruded) : random_setting(draw, limits);
  return {worked_on(draw, setting, limits, bias, extruded), bias};
}

RandomCase box_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits, Bias bias) {
  if (bias != Bias::boxes_written_out) {
    return {worked_on(draw, setting, limits, bias, thin_axis(draw, setting)), bias};
  }
  const bool admissible = draw.one_in(2);
  const Bias inner = admissible ? Bias::marks_clustered : draw.one_in(2) ? Bias::bare_scattered : Bias::bare_stacked;
  return {written_out(draw, random_case_in(draw, setting, limits, inner).content), bias};
}

}  // namespace asts
