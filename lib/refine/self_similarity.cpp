#include "lib/refine/self_similarity.hpp"

#include <algorithm>
#include <deque>

#include "lib/exact/errors.hpp"
#include "lib/refine/refinement.hpp"

namespace asts {

namespace {

constexpr int kPeriod = kDimension;  ///< phi lifts levels by one subdivision along each axis

using Index = PerAxis<std::int32_t>;

/// Calls `visit` for every unit cube of [0,window]^3; false as soon as one call returns it.
template <typename Visit>
bool for_all_cubes(std::int32_t window, Visit visit) {
  Index cube{};
  for (;;) {
    if (!visit(cube)) return false;
    std::size_t axis = 0;
    while (axis < kDimension && ++cube[axis] == window) cube[axis++] = 0;
    if (axis == kDimension) return true;
  }
}

/// The node phi(cube), kNone where a leaf is larger.
std::int32_t scaled_cube(const RefinementTree& tree, const Index& cube) {
  const std::int32_t m = tree.setting().grading;
  Index place{};
  for (std::size_t axis = 0; axis < kDimension; ++axis) place[axis] = cube[axis] / m;
  std::int32_t id = tree.unit_cube(place);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (tree.is_leaf(id)) return RefinementTree::kNone;
    id = tree.node(id).first_child + cube[axis] % m;
  }
  return id;
}

/// Whether two subtrees have the same shape.
bool same_shape(const RefinementTree& a, std::int32_t a_root, const RefinementTree& b, std::int32_t b_root) {
  std::vector<std::pair<std::int32_t, std::int32_t>> pending{{a_root, b_root}};
  while (!pending.empty()) {
    const auto [x, y] = pending.back();
    pending.pop_back();
    if (a.is_leaf(x) != b.is_leaf(y)) return false;
    if (a.is_leaf(x)) continue;
    for (std::int32_t child = 0; child < a.child_count(x); ++child) {
      pending.emplace_back(a.node(x).first_child + child, b.node(y).first_child + child);
    }
  }
  return true;
}

/// The last meshes and closures of the sequence: G_n and A_n for n = newest - 3, ..., newest.
struct Recent {
  std::deque<RefinementTree> meshes;
  std::deque<std::vector<std::int32_t>> closures;

  void push(RefinementTree mesh, std::vector<std::int32_t> closure) {
    meshes.push_back(std::move(mesh));
    closures.push_back(std::move(closure));
    if (meshes.size() <= kPeriod + 1) return;
    meshes.pop_front();
    closures.pop_front();
  }

  bool is_certificate(std::int32_t window) const {
    for (std::size_t i = 1; i < meshes.size(); ++i) {
      if (!looks_inside(meshes[i], closures[i], window)) return false;
    }
    return is_scaled_copy(meshes.front(), meshes.back(), window);
  }
};

SelfSimilarity certificate_of(const Recent& recent, std::int64_t newest, std::int32_t window,
                              std::vector<std::int64_t> new_elements) {
  SelfSimilarity result{newest - kPeriod, window, std::move(new_elements), {}};
  const std::int64_t each = recent.meshes.front().setting().grading - 1;
  for (std::size_t i = 0; i < kPeriod; ++i) {
    result.growth[i] = each * static_cast<std::int64_t>(recent.closures[i + 1].size());
  }
  return result;
}

}  // namespace

bool is_scaled_copy(const RefinementTree& coarse, const RefinementTree& fine, std::int32_t window) {
  return for_all_cubes(window, [&](const Index& cube) {
    const std::int32_t scaled = scaled_cube(fine, cube);
    return scaled != RefinementTree::kNone && same_shape(coarse, coarse.unit_cube(cube), fine, scaled);
  });
}

bool looks_inside(const RefinementTree& tree, const std::vector<std::int32_t>& closure, std::int32_t window) {
  return std::all_of(closure.begin(), closure.end(), [&](std::int32_t id) {
    if (tree.node(id).level < 1) return false;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      // an environment that the domain cuts off ends at the domain's upper face, beyond the window
      const AxisGrid& grid = tree.grid(axis);
      const std::int32_t end = grid.extent(grid.unit_cell(window)).lower;
      if (tree.environment(id, axis).upper > end) return false;
    }
    return true;
  });
}

std::optional<SelfSimilarity> find_self_similarity(const Setting& setting, std::int64_t max_steps) {
  const std::int32_t sides = *std::min_element(setting.domain.begin(), setting.domain.end());
  RefinementTree tree(setting);
  std::vector<std::int64_t> new_elements{0};
  Recent recent;
  recent.push(tree, {});
  for (std::int64_t step = 1; step <= max_steps; ++step) {
    const std::int32_t mark = tree.leaf_at(Point{});
    std::vector<std::int32_t> closure = refine(tree, std::span(&mark, 1));
    new_elements.push_back(tree.new_element_count());
    recent.push(tree, std::move(closure));
    if (step < kPeriod) continue;
    for (std::int32_t window = 1; window < sides; ++window) {
      if (recent.is_certificate(window)) return certificate_of(recent, step, window, std::move(new_elements));
    }
  }
  return std::nullopt;
}

Integer new_elements_after(const SelfSimilarity& certificate, std::int64_t steps) {
  require(steps >= 0, "a number of steps is not negative");
  const auto known = static_cast<std::int64_t>(certificate.new_elements.size()) - 1;
  if (steps <= known) return certificate.new_elements[static_cast<std::size_t>(steps)];
  const std::int64_t periods = (steps - known) / kPeriod;
  Integer result = certificate.new_elements.back();
  result += Integer(certificate.growth[0] + certificate.growth[1] + certificate.growth[2]) * periods;
  for (std::int64_t i = 0; i < (steps - known) % kPeriod; ++i)
    result += certificate.growth[static_cast<std::size_t>(i)];
  return result;
}

}  // namespace asts
