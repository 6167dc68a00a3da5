#pragma once

#include <array>
#include <cstdint>

namespace asts {

/// The dimension of the index domain. Everything loops over the axes; nothing is written out per axis.
inline constexpr int kDimension = 3;

/// An axis: 0 for x, 1 for y, 2 for z.
using Axis = int;

/// One value for each axis.
template <typename T>
using PerAxis = std::array<T, kDimension>;

/// "x", "y" or "z".
inline const char* axis_name(Axis axis) {
  static constexpr PerAxis<const char*> names{"x", "y", "z"};
  return names[static_cast<std::size_t>(axis)];
}

}  // namespace asts
