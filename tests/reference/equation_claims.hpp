#pragma once

#include "tests/reference/cube_root.hpp"
#include "tests/reference/tree.hpp"

/// The statements of Appendix A, transcribed from the paper: whether each holds for all elements of a mesh's tree.
/// REQUIRES everywhere: the boxes tile the domain.
namespace asts::reference {

/// The printed right-hand sides: equation "df size" for a level; "parent dist" by l = l(K^) and "child dist" by l =
/// l(K).
Point printed_size(const Setting& setting, int level);
Point printed_parent_distance(const Setting& setting, int level);
Point printed_child_distance(const Setting& setting, int level);

/// The sides of a box.
Point size(const Box& box);

/// p~ and s of A.3, along one axis.
RootSum p_tilde(const Setting& setting, int axis);
RootSum half_size(const Setting& setting, int axis);

bool size_formula_holds(const Setting& setting, const Mesh& mesh);
bool child_distance_holds(const Setting& setting, const Mesh& mesh);
bool child_distance_repaired_holds(const Setting& setting, const Mesh& mesh);
bool radius_step_holds(const Setting& setting, const Mesh& mesh);
bool child_bound_holds(const Setting& setting, const Mesh& mesh);
bool child_bound_repaired_holds(const Setting& setting, const Mesh& mesh);

/// The three bounds of A.3 for the mesh's elements, levels and patches. REQUIRES: every element has a level.
bool radius_bounds_hold(const Setting& setting, const Mesh& mesh);

/// Has the tree an element with children at all?
bool has_children(const Setting& setting, const Mesh& mesh);

}  // namespace asts::reference
