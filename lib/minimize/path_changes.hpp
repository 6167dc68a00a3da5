#pragma once

#include <functional>
#include <optional>

#include "lib/minimize/path_case.hpp"

namespace asts {

/// Changes of a case of steps, each a candidate for a smaller one. All keep marks within the domain, children's numbers
/// below m and, applied to a mesh, give a set of elements that mesh_of_paths() makes a mesh of.

/// Every mark by a function; nothing takes it away.
using PathMap = std::function<std::optional<ElementPath>(const ElementPath&)>;
PathCase map_paths(const PathCase& paths, const PathMap& map);

/// The axis along which a mesh is the same in all of several layers, if there is one and anything is subdivided.
std::optional<Axis> extruded_along(const PathCase& mesh);

/// Elements that differ in nothing but their layer along an axis, by level.
std::vector<std::vector<ElementPath>> rows_along(const PathCase& mesh, Axis axis);

/// What can be left out, or moved, as one: the elements that differ in nothing but their layer along extruded_along(),
/// and single elements where there is no such axis. By level.
std::vector<std::vector<ElementPath>> items_of(const PathCase& mesh);

/// The case without these elements and all that is in them.
PathCase without_elements(const PathCase& paths, const std::vector<ElementPath>& dropped);

/// The domain without `count` layers of unit cubes across an axis from `first` on, with all that lies in them.
/// REQUIRES: another layer stays.
PathCase without_layers(const PathCase& paths, Axis axis, int first, int count);

/// The domain with `count` layers more before the layer `first`, which may be one behind the last.
PathCase with_layers(const PathCase& paths, Axis axis, int first, int count);

/// What becomes of a child's number when m changes from `from` to `to`.
enum class ChildMap {
  lower_end,  ///< the same number, at most to-1
  upper_end,  ///< counted from the other end
  both_ends,  ///< the nearer end decides: the first stays the first, the last stays the last
  in_scale,   ///< at the same place within the parent
};
PathCase with_grading(const PathCase& paths, int grading, ChildMap map);

/// Everything a number of layers farther along an axis; nothing when that leaves the domain.
std::optional<PathCase> shifted(const PathCase& paths, Axis axis, int layers);

/// The domain in a mirror: x -> X~ - x along each axis that is set.
PathCase reflected(const PathCase& paths, const PerAxis<bool>& axes);

/// The children of every element in reverse order.
PathCase with_children_mirrored(const PathCase& paths);

/// Domain, degree and unit cubes with axis a of the result taken from axis order[a]. The children's numbers stay, so
/// that it is another mesh, as levels fix the axes of subdivisions (Definition 2.6).
PathCase permuted(const PathCase& paths, const PerAxis<Axis>& order);

/// The same cuts one level lower, with each axis in the place of the one before it: what was cut along y is cut along
/// x. The old x is the last axis. There a layer in which a unit cube is subdivided becomes m layers, the others stay
/// one; the first subdivisions are left out, so that fewer remain. Nothing when the domain gets too large.
std::optional<PathCase> one_level_lower(const PathCase& mesh);

}  // namespace asts
