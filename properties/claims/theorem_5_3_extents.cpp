#include <algorithm>

#include "lib/spline/slices.hpp"
#include "properties/claims/theorem_5_3_proof.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

/// A closed interval as half ranks: comparing a node's place with it is comparing coordinates.
struct Reach {
  HalfRank lower;
  HalfRank upper;

  bool contains(HalfRank first, HalfRank last) const { return lower <= first && last <= upper; }
};

/// [centre - eps factor, centre + eps factor], eps being half of K's size along the axis.
Reach reach_of(const SubdivisionStep& step, Axis axis, const Rational& centre, int factor) {
  const Rational radius = (step.upper(axis) - step.lower(axis)) / 2 * factor;
  return {half_rank(step.mesh, axis, centre - radius), half_rank(step.mesh, axis, centre + radius)};
}

Rational middle(const SubdivisionStep& step, Axis axis) { return (step.lower(axis) + step.upper(axis)) / 2; }

bool support_meets(const SubdivisionStep& step, std::int32_t node, const Box& box) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval support = step.splines.support(node, axis);
    if (2 * support.lower > box.upper[at(axis)] || 2 * support.upper < box.lower[at(axis)]) return false;
  }
  return true;
}

/// What a face's part of the claim says, on half ranks.
class SigmaExtent {
 public:
  SigmaExtent(const SubdivisionStep& step, const NewFace& face) : step_(step), face_(face) {
    const Axis x = step.role(0);
    const Axis y = step.role(1);
    const Axis z = step.role(2);
    const PerAxis<int>& p = step.mesh.setting.degree;
    sigma_y_ = reach_of(step, y, middle(step, y), p[at(y)] + 2);
    sigma_z_ = reach_of(step, z, middle(step, z), p[at(z)] + 2);
    node_x_ = reach_of(step, x, step.mesh.coordinate(x, face.line), p[at(x)] + 1);
    node_y_ = reach_of(step, y, middle(step, y), 2 * p[at(y)] + 3);
    for (const Rectangle& rectangle : face.sigma) sigma_.push_back(box_in_slice(x, 2 * face.line, rectangle));
  }

  Judgement judge() const {
    Judgement judgement;
    for (const Box& box : sigma_) {
      if (inside(box, step_.role(1), sigma_y_) && inside(box, step_.role(2), sigma_z_)) continue;
      judgement.violation = sigma_too_large(box);
      return judgement;
    }
    for (std::int32_t node = 0; node < step_.splines.size(); ++node) {
      if (!meets_sigma(node)) continue;
      ++judgement.met;
      if (!judgement.violation && !near(node)) judgement.violation = node_too_far(node);
    }
    return judgement;
  }

 private:
  static bool inside(const Box& box, Axis axis, const Reach& reach) {
    return reach.contains(box.lower[at(axis)], box.upper[at(axis)]);
  }

  bool meets_sigma(std::int32_t node) const {
    return std::any_of(sigma_.begin(), sigma_.end(), [&](const Box& box) { return support_meets(step_, node, box); });
  }

  bool near(std::int32_t node) const {
    const PerAxis<std::int32_t>& place = step_.splines.nodes[at(node)];
    const HalfRank x = 2 * place[at(step_.role(0))];
    const HalfRank y = 2 * place[at(step_.role(1))];
    return node_x_.contains(x, x) && node_y_.contains(y, y);
  }

  ClaimWitness sigma_too_large(const Box& box) const {
    ExactBox part;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      part.lower[at(axis)] = coordinate_of(step_.mesh, axis, box.lower[at(axis)]);
      part.upper[at(axis)] = coordinate_of(step_.mesh, axis, box.upper[at(axis)]);
    }
    return {"sigma-too-large",
            "a part of Sigma leaves the box that is said to contain Sigma",
            {{"element", describe_step_element(step_)},
             {"xi", step_.mesh.coordinate(step_.role(0), face_.line)},
             {"part", part}}};
  }

  ClaimWitness node_too_far(std::int32_t node) const {
    return {"node-too-far",
            "the node's support meets Sigma, but the node is outside the box that is said to contain it",
            {{"element", describe_step_element(step_)},
             {"xi", step_.mesh.coordinate(step_.role(0), face_.line)},
             {"node", describe_node(step_.mesh, step_.splines, node)}}};
  }

  const SubdivisionStep& step_;
  const NewFace& face_;
  std::vector<Box> sigma_;
  Reach sigma_y_;
  Reach sigma_z_;
  Reach node_x_;
  Reach node_y_;
};

}  // namespace

Judgement judge_sigma_extent(const SubdivisionStep& step) {
  Judgement sum;
  for (const NewFace& face : step.faces) {
    Judgement judgement = SigmaExtent(step, face).judge();
    sum.met += judgement.met;
    if (!sum.violation) sum.violation = std::move(judgement.violation);
  }
  return sum;
}

}  // namespace asts
