#pragma once

#include <optional>
#include <vector>

#include "lib/spline/index_sets.hpp"
#include "properties/witness.hpp"

namespace asts {

/// Unions of boxes of half ranks, asked for points that show what is wrong with them.

bool contains_point(const std::vector<Box>& boxes, const PerAxis<HalfRank>& point);

/// A point of one of two sets that is not in the other, if there is one. Cost: all places where membership can change.
std::optional<PerAxis<HalfRank>> point_of_difference(const std::vector<Box>& one, const std::vector<Box>& other);

/// The least common point (lexicographically) of a pair of boxes that meet, if there is one.
std::optional<PerAxis<HalfRank>> common_point(const std::vector<Box>& one, const std::vector<Box>& other);

/// The coordinates; the middle of the interval for a place between two lines.
ExactPoint point_at(const Mesh& mesh, const PerAxis<HalfRank>& position);

}  // namespace asts
