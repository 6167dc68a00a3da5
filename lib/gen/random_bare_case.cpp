#include <algorithm>

#include "lib/gen/biased_cases.hpp"
#include "lib/refine/refinement.hpp"

namespace asts {

namespace {

using Leaves = std::vector<std::int32_t>;

bool subdivide_one(GrowingCase& growing, std::int32_t leaf) {
  return growing.add(Step::Kind::subdivide, std::vector{leaf});
}

void scatter(Draw& draw, GrowingCase& growing, int steps) {
  for (; steps > 0; --steps) {
    Leaves leaves = leaves_of(growing.tree());
    draw.shuffle(leaves);
    leaves.resize(std::min(leaves.size(), draw.index(3) + 1));
    if (!growing.add(Step::Kind::subdivide, leaves)) return;
  }
}

/// Mostly below the element that was subdivided last, so that the levels jump.
void stack(Draw& draw, GrowingCase& growing, int steps, const PerAxis<std::int32_t>& cube) {
  std::int32_t last = growing.tree().unit_cube(cube);
  for (; steps > 0; --steps) {
    const std::int32_t top = draw.one_in(3) ? growing.tree().unit_cube(cube) : last;
    last = leaf_below(draw, growing.tree(), top);
    if (!subdivide_one(growing, last)) return;
  }
}

/// Refines around a random element, then subdivides the closure of a deep element without one of its coarser elements:
/// by Definition 3.1 the result is not admissible, if there is a coarser one.
void leave_one_out(Draw& draw, GrowingCase& growing) {
  std::int32_t mark = growing.tree().unit_cube(middle_cube(draw, growing.tree().setting()));
  for (int steps = draw.between(2, 3); steps > 0; --steps) {
    RefinementTree copy = growing.tree();
    Leaves closure = mark_closure(copy, std::vector{mark});  // the mark comes first, all others are coarser
    const bool last = steps == 1;
    if (last && closure.size() > 1)
      closure.erase(closure.begin() + draw.between(1, static_cast<int>(closure.size()) - 1));
    if (last) std::sort(closure.begin(), closure.end());
    if (!growing.add(last ? Step::Kind::subdivide : Step::Kind::refine, last ? closure : Leaves{mark})) return;
    mark = leaf_below(draw, growing.tree(), mark);
  }
}

/// Two stacks, p-1 to p+2 cubes apart along some axes. A node's support reaches (p+1)/2 cubes to either side, so those
/// of nodes p+1 cubes apart touch.
void touch(Draw& draw, GrowingCase& growing, int steps) {
  const Setting& setting = growing.tree().setting();
  const PerAxis<std::int32_t> first = middle_cube(draw, setting);
  PerAxis<std::int32_t> second = first;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (draw.one_in(3)) continue;
    const int far = setting.degree[axis] + draw.between(-1, 2);
    second[axis] = std::clamp(first[axis] + (draw.one_in(2) ? far : -far), 0, setting.domain[axis] - 1);
  }
  stack(draw, growing, (steps + 1) / 2, first);
  stack(draw, growing, (steps + 1) / 2, second);
}

/// Whether an element lies outside the closed active region but for its faces, on one axis at least.
bool in_frame(const RefinementTree& tree, std::int32_t leaf) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree.grid(axis);
    const RankInterval extent = tree.extent(leaf, axis);
    const int frame = (tree.setting().degree[at(axis)] + 1) / 2;
    if (grid.coordinate(grid.line_of_rank(extent.upper)) <= frame) return true;
    if (grid.coordinate(grid.line_of_rank(extent.lower)) >= tree.setting().domain[at(axis)] - frame) return true;
  }
  return false;
}

void subdivide_frame(Draw& draw, GrowingCase& growing, int steps) {
  for (; steps > 0; --steps) {
    Leaves frame;
    for (const std::int32_t leaf : leaves_of(growing.tree())) {
      if (in_frame(growing.tree(), leaf)) frame.push_back(leaf);
    }
    draw.shuffle(frame);
    frame.resize(std::min(frame.size(), draw.index(4) + 1));
    if (!growing.add(Step::Kind::subdivide, frame)) return;
  }
}

}  // namespace

std::int32_t leaf_below(Draw& draw, const RefinementTree& tree, std::int32_t id) {
  while (!tree.is_leaf(id)) id = tree.node(id).first_child + draw.between(0, tree.child_count(id) - 1);
  return id;
}

PerAxis<std::int32_t> middle_cube(Draw& draw, const Setting& setting) {
  PerAxis<std::int32_t> cube{};
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const int last = setting.domain[axis] - 1;
    const int frame = std::min((setting.degree[axis] - 1) / 2, last / 2);
    cube[axis] = draw.between(frame, last - frame);
  }
  return cube;
}

void subdivide_at_least_once(GrowingCase& growing) {
  const auto bare = [](const Step& step) { return step.kind == Step::Kind::subdivide; };
  const auto& done = growing.content().steps;
  if (std::none_of(done.begin(), done.end(), bare)) subdivide_one(growing, leaves_of(growing.tree()).front());
}

RandomCase bare_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits, Bias bias) {
  GrowingCase growing(setting, limits.max_elements);
  const int steps = draw.between(1, limits.max_steps);
  switch (bias) {
    case Bias::bare_stacked:
      stack(draw, growing, steps, middle_cube(draw, growing.tree().setting()));
      break;
    case Bias::bare_one_left_out:
      leave_one_out(draw, growing);
      break;
    case Bias::bare_touching:
      touch(draw, growing, steps);
      break;
    case Bias::bare_in_frame:
      subdivide_frame(draw, growing, steps);
      break;
    default:
      scatter(draw, growing, steps);
  }
  subdivide_at_least_once(growing);
  return {growing.content(), bias};
}

RandomCase random_bare_case(Draw& draw, const CaseLimits& limits) {
  const Bias bias = draw.choose(std::vector{Bias::bare_scattered, Bias::bare_stacked, Bias::bare_one_left_out,
                                            Bias::bare_touching, Bias::bare_in_frame});
  return bare_case_in(draw, random_setting(draw, limits), limits, bias);
}

}  // namespace asts
