#pragma once

#include <cstdint>

#include "tests/reference/mesh.hpp"

namespace asts::reference {

/// Coordinates multiplied by one integer: the same numbers in another unit, so every comparison has the same answer.
using Grid = std::int64_t;

/// Twice the least common multiple of the mesh's denominators, when every coordinate of the domain times it is below
/// 2^62; otherwise nothing, and the caller stays with rationals. Twice, so that the corners of U(K) are on the grid
/// too: mid(K) halves a sum of corners, and D(l(K)) is (p + 3/2) times K's sides.
std::optional<Grid> grid_scale(const Setting& setting, const Mesh& mesh);

/// value * scale. Throws std::logic_error when that is no integer of 63 bits.
Grid on_grid(const Rational& value, Grid scale);

/// The box in units of 1/scale; with T = Rational the scale is 1 and the box is copied.
template <class T>
BasicBox<T> in_units(const Box& box, Grid scale);

}  // namespace asts::reference
