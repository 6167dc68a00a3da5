#include "lib/gen/workloads.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "lib/exact/errors.hpp"
#include "lib/gen/draw.hpp"
#include "lib/gen/growing_case.hpp"
#include "lib/mesh/refinement_tree.hpp"
#include "lib/refine/refinement.hpp"

namespace asts {

namespace {

constexpr std::array<std::string_view, 3> kNames{"corner", "sphere", "random"};

/// Of `random`. One leaf in so many is drawn: the closure adds so much that fewer steps would overshoot a number of
/// elements by far.
constexpr std::uint64_t kSeed = 1;
constexpr std::size_t kLeavesForOneMark = 64;

/// The coordinates of an axis's lines, by rank, measured so that the comparisons with the sphere are between squares:
/// 4 (coordinate - centre), squared.
struct Distances {
  PerAxis<std::vector<Rational>> squared;
  PerAxis<std::vector<bool>> below_centre;
  Rational radius_squared;  ///< of 4 times the radius: the shortest side

  explicit Distances(const RefinementTree& tree) {
    const auto shortest = *std::min_element(tree.setting().domain.begin(), tree.setting().domain.end());
    radius_squared = Rational(shortest) * shortest;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const AxisGrid& grid = tree.grid(axis);
      for (std::int32_t rank = 0; rank < grid.line_count(); ++rank) {
        const Rational offset = 4 * grid.coordinate(grid.line_of_rank(rank)) - 2 * tree.setting().domain[at(axis)];
        below_centre[at(axis)].push_back(offset < 0);
        squared[at(axis)].push_back(offset * offset);
      }
    }
  }
};

bool meets_sphere(const RefinementTree& tree, const Distances& distances, std::int32_t id) {
  Rational nearest = 0;
  Rational farthest = 0;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval side = tree.extent(id, axis);
    const Rational& lower = distances.squared[at(axis)][at(side.lower)];
    const Rational& upper = distances.squared[at(axis)][at(side.upper)];
    farthest += std::max(lower, upper);
    const bool holds_centre =
        distances.below_centre[at(axis)][at(side.lower)] && !distances.below_centre[at(axis)][at(side.upper)];
    if (!holds_centre) nearest += std::min(lower, upper);
  }
  return nearest <= distances.radius_squared && distances.radius_squared <= farthest;
}

/// A leaf meets the sphere only if all nodes above it do: the search goes down from the domain.
std::vector<std::int32_t> leaves_on_sphere(const RefinementTree& tree) {
  const Distances distances(tree);
  std::vector<std::int32_t> leaves;
  std::vector<std::int32_t> pending{0};
  while (!pending.empty()) {
    const std::int32_t id = pending.back();
    pending.pop_back();
    if (!meets_sphere(tree, distances, id)) continue;
    if (tree.is_leaf(id)) {
      leaves.push_back(id);
      continue;
    }
    tree.push_children(id, pending);
  }
  return leaves;
}

std::vector<std::int32_t> random_leaves(const RefinementTree& tree, Draw& draw) {
  const std::vector<std::int32_t> leaves = leaves_of(tree);
  std::vector<std::int32_t> drawn((leaves.size() + kLeavesForOneMark - 1) / kLeavesForOneMark);
  for (std::int32_t& leaf : drawn) leaf = draw.choose(leaves);
  std::sort(drawn.begin(), drawn.end());
  drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
  return drawn;
}

std::vector<std::int32_t> marks_of(Workload workload, const RefinementTree& tree, Draw& draw) {
  switch (workload) {
    case Workload::corner:
      return {tree.leaf_at(Point{})};
    case Workload::sphere:
      return leaves_on_sphere(tree);
    case Workload::random:
      return random_leaves(tree, draw);
  }
  throw InternalError("a workload without marks");
}

}  // namespace

std::span<const std::string_view> workload_names() { return kNames; }

Workload workload_named(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) throw InputError("no workload is called '" + std::string(name) + "'");
  return static_cast<Workload>(found - kNames.begin());
}

Case generate_workload(Workload workload, const Setting& setting, std::int64_t elements) {
  Case result{setting.degree, setting.grading, setting.domain, {}, false, {}};
  RefinementTree tree(setting);
  Draw draw(kSeed);
  while (tree.element_count() < elements) {
    const std::vector<std::int32_t> marks = marks_of(workload, tree, draw);
    Step step;
    for (const std::int32_t leaf : marks) step.marks.push_back(lower_corner(tree, leaf));
    result.steps.push_back(std::move(step));
    refine(tree, marks);
  }
  return result;
}

}  // namespace asts
