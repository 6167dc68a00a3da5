#include "tests/minimize/fault_predicates.hpp"

#include <algorithm>

#include "lib/gen/smaller_patch.hpp"
#include "lib/mesh/level_formulas.hpp"
#include "lib/refine/admissibility.hpp"
#include "lib/refine/refinement.hpp"
#include "lib/refine/replay.hpp"
#include "lib/spline/dual_compatibility.hpp"
#include "properties/mesh_under_test.hpp"

namespace asts {

namespace {

using Leaves = std::vector<std::int32_t>;

Rational coordinate(const RefinementTree& tree, Axis axis, std::int32_t rank) {
  return tree.grid(axis).coordinate(tree.grid(axis).line_of_rank(rank));
}

void make_distinct(Leaves& leaves) {
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
}

/// Follows the steps with another closure than Algorithm 2.8; nothing when a step is no `refine`.
template <class Closure>
Violation inadmissible_with(const Case& test_case, const Closure& closure) {
  if (test_case.explicit_mesh) return std::nullopt;
  RefinementTree tree(setting_of(test_case));
  for (const Step& step : test_case.steps) {
    if (step.kind != Step::Kind::refine) return std::nullopt;
    Leaves marks;
    for (const Point& mark : step.marks) marks.push_back(tree.leaf_at(mark));
    make_distinct(marks);
    Leaves subdivided = closure(tree, marks);
    make_distinct(subdivided);
    subdivide_all(tree, subdivided);
  }
  if (!find_inadmissible(tree)) return std::nullopt;
  return "not-admissible";
}

Leaves right_closure(const RefinementTree& tree, const Leaves& marks) {
  RefinementTree copy = tree;
  return mark_closure(copy, marks);
}

/// The marks and the coarser elements in their patches.
Leaves closure_of_one_round(const RefinementTree& tree, const Leaves& marks) {
  Leaves result = marks;
  for (const std::int32_t mark : marks) {
    for (std::int32_t id = 0; id < tree.node_count(); ++id) {
      if (!tree.is_leaf(id) || tree.node(id).level >= tree.node(mark).level) continue;
      bool meets = true;
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const RankInterval open = tree.environment(mark, axis);
        const RankInterval extent = tree.extent(id, axis);
        meets = meets && extent.lower < open.upper && open.lower < extent.upper;
      }
      if (meets) result.push_back(id);
    }
  }
  return result;
}

/// Gives the last mesh of a case of steps to a statement about meshes.
template <class Decide>
Violation on_last_mesh(const Case& test_case, const Decide& decide) {
  if (test_case.explicit_mesh) return std::nullopt;
  Replay replay(test_case);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  return decide(mesh);
}

/// The lines of the closed environment of an element: from the first to the last.
PerAxis<RankInterval> closed_lines(const RefinementTree& tree, std::int32_t id) {
  const Setting& setting = tree.setting();
  const PerAxis<Rational> radius = level_radius(setting.degree, setting.grading, tree.node(id).level);
  PerAxis<RankInterval> lines;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval extent = tree.extent(id, axis);
    const Rational middle = (coordinate(tree, axis, extent.lower) + coordinate(tree, axis, extent.upper)) / 2;
    std::int32_t first = extent.lower;
    std::int32_t last = extent.upper;
    while (first > 0 && coordinate(tree, axis, first - 1) >= middle - radius[at(axis)]) --first;
    const std::int32_t end = tree.grid(axis).line_count() - 1;
    while (last < end && coordinate(tree, axis, last + 1) <= middle + radius[at(axis)]) ++last;
    lines[at(axis)] = {first, last};
  }
  return lines;
}

/// Whether a coarser leaf than an element has a point in common with its closed environment.
bool has_coarser_in(const RefinementTree& tree, std::int32_t element) {
  const PerAxis<RankInterval> lines = closed_lines(tree, element);
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (!tree.is_leaf(id) || tree.node(id).level >= tree.node(element).level) continue;
    bool touches = true;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const RankInterval extent = tree.extent(id, axis);
      touches = touches && extent.lower <= lines[at(axis)].upper && lines[at(axis)].lower <= extent.upper;
    }
    if (touches) return true;
  }
  return false;
}

bool is_integer(const Rational& number) { return boost::multiprecision::denominator(number) == 1; }

PerAxis<Rational> place_of(MeshUnderTest& mesh, std::int32_t node) {
  PerAxis<Rational> place;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    place[at(axis)] = mesh.mesh().coordinate(axis, mesh.splines().nodes[at(node)][at(axis)]);
  }
  return place;
}

}  // namespace

Violation short_environment(const Case& test_case, Planted fault) {
  if (fault == Planted::no) return inadmissible_with(test_case, right_closure);
  return inadmissible_with(
      test_case, [](const RefinementTree& tree, const Leaves& marks) { return smaller_closure(tree, marks); });
}

Violation single_round(const Case& test_case, Planted fault) {
  return fault == Planted::no ? inadmissible_with(test_case, right_closure)
                              : inadmissible_with(test_case, closure_of_one_round);
}

Violation closed_environment(const Case& test_case, Planted fault) {
  return on_last_mesh(test_case, [&](MeshUnderTest& mesh) -> Violation {
    if (!mesh.admissible() || fault == Planted::no) return std::nullopt;  // the statement is the definition
    for (std::int32_t id = 0; id < mesh.tree().node_count(); ++id) {
      const bool subdivided = mesh.tree().node(id).level >= 0 && !mesh.tree().is_leaf(id);
      if (subdivided && has_coarser_in(mesh.tree(), id)) return "coarser-touches";
    }
    return std::nullopt;
  });
}

Violation level_of_few_splits(const Case& test_case, Planted fault) {
  return on_last_mesh(test_case, [&](MeshUnderTest& mesh) -> Violation {
    const RefinementTree& tree = mesh.tree();
    for (std::int32_t id = 0; id < tree.node_count(); ++id) {
      if (!tree.is_leaf(id)) continue;
      const std::int32_t level = tree.node(id).level;
      const std::int32_t along_z = level / kDimension;
      const std::int32_t counted = fault == Planted::yes ? level - std::max(0, along_z - 1) : level;
      const PerAxis<Rational> size = level_size(tree.setting().grading, counted);
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const RankInterval extent = tree.extent(id, axis);
        if (coordinate(tree, axis, extent.upper) - coordinate(tree, axis, extent.lower) != size[at(axis)]) {
          return "other-size";
        }
      }
    }
    return std::nullopt;
  });
}

Violation late_index_vector(const Case& test_case, Planted fault) {
  return on_last_mesh(test_case, [&](MeshUnderTest& mesh) -> Violation {
    constexpr Axis kY = 1;
    for (std::int32_t node = 0; node < mesh.splines().size(); ++node) {
      const std::span<const std::int32_t> vector = mesh.splines().index_vector(node, kY);
      const bool late = fault == Planted::yes && !is_integer(place_of(mesh, node)[at(kY)]);
      const std::size_t middle = vector.size() / 2 - (late ? 1 : 0);
      if (vector[middle] != mesh.splines().nodes[at(node)][at(kY)]) return "not-in-the-middle";
    }
    return std::nullopt;
  });
}

Violation mixed_frame(const Case& test_case, Planted fault) {
  return on_last_mesh(test_case, [&](MeshUnderTest& mesh) -> Violation {
    const Setting& setting = mesh.mesh().setting;
    const int frame = (setting.degree[fault == Planted::yes ? 2 : 1] + 1) / 2;
    for (std::int32_t node = 0; node < mesh.splines().size(); ++node) {
      const PerAxis<Rational> place = place_of(mesh, node);
      if (std::all_of(place.begin(), place.end(), is_integer)) continue;
      if (place[1] < frame || place[1] > setting.domain[1] - frame) return "outside";
    }
    return std::nullopt;
  });
}

Violation overlap_along_all_axes(const Case& test_case, Planted fault) {
  return on_last_mesh(test_case, [&](MeshUnderTest& mesh) -> Violation {
    if (!mesh.admissible() || mesh.splines().nodes.empty()) return std::nullopt;
    const bool fails =
        fault == Planted::yes ? count_overlap_failures(mesh.bricks()) > 0 : mesh.incompatible().has_value();
    return fails ? Violation("no-overlap") : std::nullopt;
  });
}

Violation slices_of_domain(const Case& test_case, Planted fault) {
  return on_last_mesh(test_case, [&](MeshUnderTest& mesh) -> Violation {
    if (mesh.splines().nodes.empty() || mesh.meeting_regions() || fault == Planted::no) return std::nullopt;
    if (!find_meeting(perturbed_regions(mesh.bricks(), whole_domain(mesh.mesh())))) return std::nullopt;
    return "regions-meet";
  });
}

}  // namespace asts
