#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace asts {

/// The dimension of the index domain. Everything loops over the axes; nothing is written out per axis.
inline constexpr int kDimension = 3;

/// An axis: 0 for x, 1 for y, 2 for z.
using Axis = int;

/// The next axis, in a circle.
constexpr Axis axis_after(Axis axis) { return (axis + 1) % kDimension; }

/// One value for each axis.
template <typename T>
using PerAxis = std::array<T, kDimension>;

/// An axis, a rank or an identifier as an index of a container. REQUIRES: id >= 0.
constexpr std::size_t at(std::int32_t id) { return static_cast<std::size_t>(id); }

/// "x", "y" or "z".
inline const char* axis_name(Axis axis) {
  static constexpr PerAxis<const char*> names{"x", "y", "z"};
  return names[at(axis)];
}

}  // namespace asts
