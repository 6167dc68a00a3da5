#include <algorithm>

#include "lib/spline/slices.hpp"
#include "properties/claims/region_points.hpp"
#include "properties/claims/theorem_5_3_proof.hpp"
#include "properties/describe.hpp"
#include "properties/properties.hpp"

namespace asts {

namespace {

/// A region without its slices at the new xi.
std::vector<Box> away_from_new_faces(const SubdivisionStep& step, const std::vector<Box>& region) {
  std::vector<Box> result;
  for (const Box& box : region) {
    const auto here = [&](const NewFace& face) { return 2 * face.line == box.lower[at(step.role(0))]; };
    if (std::none_of(step.faces.begin(), step.faces.end(), here)) result.push_back(box);
  }
  return result;
}

std::optional<ClaimWitness> region_changed(const SubdivisionStep& step, Axis axis, const std::vector<Box>& old_region,
                                           const std::vector<Box>& new_region) {
  if (old_region == new_region) return std::nullopt;
  const auto point = point_of_difference(old_region, new_region);
  if (!point) return std::nullopt;
  return ClaimWitness{"region-changed",
                      "away from the new slices the perturbed region of the axis is not the same after the step: only "
                      "one of them has the point",
                      {{"element", describe_step_element(step)},
                       {"axis", std::string(axis_name(axis))},
                       {"point", point_at(step.mesh, *point)},
                       {"in", std::string(contains_point(old_region, *point) ? "before" : "after")}}};
}

std::vector<Box> boxes_of(const SubdivisionStep& step, const NewFace& face, const std::vector<Rectangle>& rectangles) {
  std::vector<Box> boxes;
  for (const Rectangle& rectangle : rectangles) boxes.push_back(box_in_slice(step.role(0), 2 * face.line, rectangle));
  return boxes;
}

std::optional<ClaimWitness> meets_other_regions(const SubdivisionStep& step, const NewFace& face) {
  const std::vector<Box> boxes = boxes_of(step, face, face.sigma);
  for (const Axis axis : {step.role(1), step.role(2)}) {
    const auto point = common_point(boxes, step.hatted_regions[at(axis)]);
    if (!point) continue;
    return ClaimWitness{"sigma-meets-region",
                        "Sigma meets the perturbed region of the axis, after the step, in the point",
                        {{"element", describe_step_element(step)},
                         {"xi", step.mesh.coordinate(step.role(0), face.line)},
                         {"axis", std::string(axis_name(axis))},
                         {"point", point_at(step.mesh, *point)}}};
  }
  return std::nullopt;
}

std::vector<Rectangle> slice_of_region(const SubdivisionStep& step, const NewFace& face,
                                       const std::vector<Box>& region) {
  std::vector<Rectangle> result;
  for (const Box& box : region) {
    if (box.lower[at(step.role(0))] == 2 * face.line) result.push_back(rectangle_of(step.role(0), box));
  }
  return result;
}

ClaimWitness slice_witness(const SubdivisionStep& step, const NewFace& face, const char* kind, const char* says,
                           const PerAxis<HalfRank>& point) {
  return {kind,
          says,
          {{"element", describe_step_element(step)},
           {"xi", step.mesh.coordinate(step.role(0), face.line)},
           {"point", point_at(step.mesh, point)}}};
}

/// A point of the first set that is not in the second: where its intersection with the second is not the set itself.
std::optional<PerAxis<HalfRank>> point_outside(const SubdivisionStep& step, const NewFace& face,
                                               const std::vector<Rectangle>& set,
                                               const std::vector<Rectangle>& allowed) {
  UnionIntersection intersection;
  const std::vector<Rectangle> all = intersection.of(set, set);
  const std::vector<Rectangle> common = intersection.of(set, allowed);
  if (all == common) return std::nullopt;
  return point_of_difference(boxes_of(step, face, all), boxes_of(step, face, common));
}

/// R^_x(xi) within R_x(xi) u Sigma, and Sigma not larger for the nodes of P \ N_x(xi).
std::optional<ClaimWitness> outside_old_and_sigma(const SubdivisionStep& step, const NewFace& face) {
  if (const auto point = point_outside(step, face, face.large_sigma, face.sigma)) {
    return slice_witness(step, face, "larger-sigma",
                         "the point is in the slice and in the support of an old node whose projection is in the new "
                         "face and not in the old slice's nodes, and it is not in Sigma",
                         *point);
  }
  const auto a = at(step.role(0));
  std::vector<Rectangle> allowed = slice_of_region(step, face, step.regions[a]);
  allowed.insert(allowed.end(), face.sigma.begin(), face.sigma.end());
  const auto point = point_outside(step, face, slice_of_region(step, face, step.hatted_regions[a]), allowed);
  if (!point) return std::nullopt;
  return slice_witness(step, face, "outside-old-region-and-sigma",
                       "the point is in the slice perturbation after the step, not in the one before it, and not in "
                       "Sigma",
                       *point);
}

ClaimWitness wrong_member(const SubdivisionStep& step, const NewFace& face, std::size_t node) {
  const auto id = static_cast<std::int32_t>(node);
  const auto yes_or_no = [](bool answer) { return std::string(answer ? "yes" : "no"); };
  return {
      "wrong-slice-node",
      "the split says of the node the opposite of what it is after the step: in the nodes of the slice at xi or not",
      {{"element", describe_step_element(step)},
       {"xi", step.mesh.coordinate(step.role(0), face.line)},
       {"node", describe_node(step.mesh, step.splines, id)},
       {"new", yes_or_no(step.is_new[node])},
       {"in_slice_before", yes_or_no(face.members[node])},
       {"in_slice_after", yes_or_no(face.hatted_members[node])}}};
}

/// Compares N^_x(xi) with what a split says of each node. Met: 1 if N^_x(xi) differs from N_x(xi).
template <class Expected>
Judgement judge_split(const SubdivisionStep& step, const NewFace& face, const Expected& expected) {
  Judgement judgement;
  judgement.met = face.hatted_members != face.members;
  for (std::size_t node = 0; node < face.hatted_members.size(); ++node) {
    if (face.hatted_members[node] == expected(node)) continue;
    judgement.violation = wrong_member(step, face, node);
    break;
  }
  return judgement;
}

template <class Judge>
Judgement judge_faces(const SubdivisionStep& step, const Judge& judge) {
  Judgement sum;
  for (const NewFace& face : step.faces) {
    Judgement judgement = judge(face);
    sum.met += judgement.met;
    if (!sum.violation) sum.violation = std::move(judgement.violation);
  }
  return sum;
}

}  // namespace

Trial regions_apart(MeshUnderTest& mesh) {
  Trial trial{decide_analysis_suitable(mesh)};
  if (trial.verdict.outcome == Outcome::not_applicable) return trial;
  const PerturbedRegions& regions = mesh.perturbed_regions();
  for (std::size_t a = 0; a < kDimension; ++a) {
    for (std::size_t b = 0; b < a; ++b) trial.met += !regions[a].empty() && !regions[b].empty();
  }
  return trial;
}

Judgement judge_kept_regions(const SubdivisionStep& step) {
  Judgement judgement;
  const auto& regions = step.regions;
  const bool perturbed = std::any_of(regions.begin(), regions.end(), [](const auto& list) { return !list.empty(); });
  judgement.met = perturbed && std::find(step.is_new.begin(), step.is_new.end(), true) != step.is_new.end();
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const bool own = axis == step.role(0);
    const auto before = own ? away_from_new_faces(step, step.regions[at(axis)]) : step.regions[at(axis)];
    const auto after = own ? away_from_new_faces(step, step.hatted_regions[at(axis)]) : step.hatted_regions[at(axis)];
    if (!judgement.violation) judgement.violation = region_changed(step, axis, before, after);
  }
  return judgement;
}

Judgement judge_sigma_unperturbed(const SubdivisionStep& step) {
  const bool others = !step.hatted_regions[at(step.role(1))].empty() || !step.hatted_regions[at(step.role(2))].empty();
  return judge_faces(step, [&](const NewFace& face) {
    return Judgement{meets_other_regions(step, face), others && !face.sigma.empty()};
  });
}

Judgement judge_new_node_split(const SubdivisionStep& step) {
  return judge_faces(step, [&](const NewFace& face) {
    return judge_split(step, face, [&](std::size_t node) { return face.members[node] || step.is_new[node]; });
  });
}

Judgement judge_new_node_split_repaired(const SubdivisionStep& step) {
  return judge_faces(step, [&](const NewFace& face) {
    Judgement judgement = judge_split(
        step, face, [&](std::size_t node) { return face.members[node] || step.is_new[node] || face.projected[node]; });
    if (!judgement.violation) judgement.violation = outside_old_and_sigma(step, face);
    return judgement;
  });
}

}  // namespace asts
