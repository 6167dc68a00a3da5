#pragma once

#include <array>
#include <cstdint>

#include "lib/spline/bricks.hpp"

namespace asts {

/// How many unordered pairs of different active nodes have closed supports whose intersection has each dimension:
/// by_dimension[3] share volume, [2] touch in a face, [1] in an edge, [0] in a point. Pairs with disjoint supports are
/// not counted.
struct SupportContacts {
  std::array<std::int64_t, kDimension + 1> by_dimension{};

  friend bool operator==(const SupportContacts&, const SupportContacts&) = default;
};

/// Counts them. Along each axis the indices of two bricks are free, so the pairs that meet in an interval and those
/// that meet in a point are counted for two profiles once and multiplied out. Cost: linear in the pairs of bricks.
SupportContacts count_contacts(const TSplines& splines, const Bricks& bricks);

}  // namespace asts
