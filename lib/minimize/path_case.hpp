#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/mesh/case.hpp"
#include "lib/mesh/setting.hpp"

namespace asts {

/// An element of level k as the way to it: the index of its unit cube along each axis, then for each of its k
/// subdivisions (Definition 2.6) the number of the child, 0 to m-1. It stays what it is when the domain grows or m
/// changes, which its coordinates would not, and has no bound on the level.
using ElementPath = std::vector<std::int32_t>;

/// REQUIRES: at least the unit cube.
inline std::int32_t level_of(const ElementPath& path) { return static_cast<std::int32_t>(path.size()) - kDimension; }

/// Whether one element contains the other, or is it.
bool leads_to(const ElementPath& ancestor, const ElementPath& element);

/// A step with its marks as elements.
struct PathStep {
  Step::Kind kind = Step::Kind::subdivide;
  std::vector<ElementPath> marks;

  friend bool operator==(const PathStep&, const PathStep&) = default;
};

/// A case of steps in the form in which the minimizer changes it. Two forms occur.
/// - A mesh: one `subdivide` step a level, from level 0 on, which names all elements of the level that are subdivided,
///   in ascending order; every subdivided element's parent is subdivided. A mesh has one such form.
/// - A sequence: any steps. A mark names the element that has the path when the step's turn comes; where that is no
///   element of the mesh, the one that contains its lower corner.
struct PathCase {
  Setting setting;
  std::vector<PathStep> steps;
};

/// The mesh that the case's steps make, or that its boxes are: nothing when a box is none that subdivisions make.
/// Throws what the replay and mesh_of throw.
std::optional<PathCase> mesh_paths(const Case& test_case);

/// A sequence of steps and how many elements are subdivided in its last mesh.
struct FollowedPaths {
  PathCase paths;
  std::int64_t subdivisions = 0;
};

/// The case's steps, each mark the element that it names then; ascending, each once, and no empty step. Meshes are
/// followed by a tree of all elements, or, when there are more than a million, by the set of the subdivided ones
/// (lib/refine/subdivided_elements.hpp). Throws InputError for an explicit mesh, ResourceError when neither is
/// possible.
FollowedPaths follow_paths(const Case& test_case);

/// The mesh of a set of elements, each with all those it is in.
PathCase mesh_of_paths(const Setting& setting, std::vector<ElementPath> subdivided);
/// All elements of all steps. REQUIRES: a mesh.
std::vector<ElementPath> subdivided_of(const PathCase& mesh);

/// Every mark is written as the lower corner of its element.
Case case_of(const PathCase& paths);

}  // namespace asts
