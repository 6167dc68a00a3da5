#pragma once

#include <vector>

#include "lib/gen/growing_case.hpp"
#include "lib/gen/random_case.hpp"

/// What the generators of random_case.hpp are made of: one function for each origin of cases, in a given setting.
namespace asts {

RandomCase admissible_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits, Bias bias);
RandomCase bare_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits, Bias bias);
RandomCase box_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits, Bias bias);
RandomCase trouble_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits, Bias bias);

RandomCase planar_inside_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits);

/// The setting of a trouble bias.
Setting trouble_setting(Draw& draw, const CaseLimits& limits, Bias bias);

/// A column of unit cubes along an axis, with the level that each is subdivided to.
struct Column {
  std::size_t axis = 0;
  PerAxis<std::int32_t> cube{};      ///< one of them
  std::vector<std::int32_t> levels;  ///< by the place along the axis
};

/// Subdivides the column level by level, on towards one corner of the cubes' common section, so that the finer elements
/// stand above each other.
void subdivide_column(Draw& draw, GrowingCase& growing, const Column& column);

/// A unit cube in the middle part of the domain, with sides no farther than one cube from the active region.
PerAxis<std::int32_t> middle_cube(Draw& draw, const Setting& setting);

/// A random leaf below a node of the tree.
std::int32_t leaf_below(Draw& draw, const RefinementTree& tree, std::int32_t id);

/// A bare case without a subdivision says nothing: subdivides the first element if there was none.
void subdivide_at_least_once(GrowingCase& growing);

}  // namespace asts
