#pragma once

#include <span>

#include "lib/minimize/path_search.hpp"

namespace asts {

/// One way to look for smaller cases around the current one. Proposes candidates in a fixed order that depends on the
/// current case alone; true when one was accepted.
struct PathPass {
  const char* name;
  bool (*run)(PathSearch& search);
};

/// More marks are not moved, and more steps not merged, one by one; nor is a case with more of them looked at in larger
/// settings.
inline constexpr std::size_t kMostMoved = 64;

/// What makes a case smaller step by step: cheap, and enough to come from a large case to a small one.
std::span<const PathPass> descent_passes();
/// What leads out of a case that none of these makes smaller.
std::span<const PathPass> escape_passes();

bool drop_elements(PathSearch& search);  ///< items of a mesh with all below them; steps and marks of a sequence
bool drop_layers(PathSearch& search);    ///< layers of the domain, on either side and between
bool drop_frame(PathSearch& search);     ///< the outermost layers across one axis or some
bool lower_degrees(PathSearch& search);  ///< by 2, with and without a layer of the frame on each side
bool lower_grading(PathSearch& search);  ///< m
bool permute_axes(PathSearch& search);
bool move_to_origin(PathSearch& search);  ///< unit cubes and children's numbers of elements
bool reflect_axes(PathSearch& search);
bool merge_steps(PathSearch& search);        ///< of a sequence: neighbours of one kind
bool write_out_closure(PathSearch& search);  ///< of a sequence: the bare steps that make its last mesh

/// A larger setting in which fewer subdivisions do: one layer more, degree 2 higher, a higher m.
bool grow_and_drop(PathSearch& search);
/// Elements of an extruded mesh one by one, so that it is extruded no more.
bool drop_single_elements(PathSearch& search);
/// What is in one unit cube moved into another, with all shifted by a layer or not, and the domain longer by one or
/// not.
bool join_cubes(PathSearch& search);
/// The same cuts one level lower, along other axes.
bool lower_levels(PathSearch& search);
/// A degree lower by 2 with two layers less anywhere.
bool lower_degree_inside(PathSearch& search);
/// What is in two neighbouring layers put into one of them, as it is and without an item.
bool join_layers(PathSearch& search);
/// Nothing subdivided in the outermost layers, with some empty ones more or not.
bool clear_ends(PathSearch& search);
/// The axes exchanged, with a lower m or with layers less of the longest one.
bool turn_and_cut(PathSearch& search);
/// A higher m on a domain with a layer less.
bool refine_and_cut(PathSearch& search);
/// Another shape of the domain of less volume, with the elements moved along.
bool reshape_domain(PathSearch& search);

/// Runs the passes over and over until none of them accepts anything.
void descend(PathSearch& search);

}  // namespace asts
