#include "properties/claims/independence.hpp"

#include <string>

#include "lib/exact/errors.hpp"
#include "lib/spline/axis_overlap.hpp"
#include "lib/spline/dual_compatibility.hpp"
#include "lib/spline/independence.hpp"
#include "properties/describe.hpp"
#include "properties/splines_needed.hpp"

namespace asts {
namespace {

/// A dense elimination of this size takes seconds.
constexpr std::int32_t kMostNodes = 3000;

Witness describe(const Mesh& mesh, const TSplines& splines, const std::vector<Integer>& dependence) {
  ClaimWitness witness{"dependent", "the sum of coefficient times B_node is 0 on every element", {}};
  int number = 0;
  for (std::int32_t v = 0; v < splines.size(); ++v) {
    if (dependence[at(v)].is_zero()) continue;
    const std::string suffix = std::to_string(++number);
    witness.values.emplace_back(std::string("coefficient_").append(suffix), Rational(dependence[at(v)]));
    witness.values.emplace_back(std::string("node_").append(suffix), describe_node(mesh, splines, v));
  }
  return witness;
}

}  // namespace

Verdict judge_independence(const Mesh& mesh, const TSplines& splines) {
  if (splines.size() > kMostNodes) throw BudgetExhausted("too many active nodes for an elimination");
  const auto dependence = find_dependence(mesh, splines);
  if (!dependence) return Verdict::holds();
  ensure(vanishes_everywhere(mesh, splines, *dependence), "a dependence vanishes on every element");
  return Verdict::violated(describe(mesh, splines, *dependence));
}

std::int64_t pairs_partially_overlapping(const Bricks& bricks) {
  std::vector<AxisOverlap> overlaps;
  for (Axis axis = 0; axis < kDimension; ++axis) overlaps.emplace_back(bricks, axis);
  std::int64_t count = 0;
  for (const auto& [i, j] : bricks.pairs) {
    const Brick& one = bricks.bricks[at(i)];
    const Brick& other = bricks.bricks[at(j)];
    if (!interiors_meet(one.support, other.support)) continue;
    int axes = 0;
    for (AxisOverlap& overlap : overlaps) axes += overlap.holds(one, other) ? 1 : 0;
    count += axes == kDimension - 1 ? 1 : 0;
  }
  return count;
}

Trial try_independence(MeshUnderTest& mesh) {
  if (auto verdict = lacks_splines(mesh)) return {*verdict};
  if (find_incompatible(mesh.splines(), mesh.bricks())) {
    return {Verdict::not_applicable("the mesh is not dual-compatible")};
  }
  return {judge_independence(mesh.mesh(), mesh.splines()), pairs_partially_overlapping(mesh.bricks())};
}

}  // namespace asts
