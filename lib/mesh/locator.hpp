#pragma once

#include <cstdint>
#include <vector>

#include "lib/mesh/axis.hpp"

namespace asts {

/// A hierarchy of cuts through the domain that ends in the elements of a mesh: finds the element that covers a cell
/// between neighbouring lines.
struct Locator {
  struct Node {
    std::int32_t axis;   ///< along which the children lie; -1 for a leaf
    std::int32_t first;  ///< the first child, or the leaf's element
    std::int32_t count;  ///< of children
    std::int32_t lower;  ///< the rank where this node begins, along its parent's axis
  };

  std::vector<Node> nodes;  ///< node 0 is the domain

  /// The element that covers, on each axis, the interval between the lines of rank interval[axis] and the next one.
  /// REQUIRES: the cell lies in the domain. Cost: linear in the depth of the hierarchy.
  std::int32_t element_at(const PerAxis<std::int32_t>& interval) const {
    const Node* node = nodes.data();
    while (node->axis >= 0) {
      const std::int32_t place = interval[at(node->axis)];
      std::int32_t low = 0;
      std::int32_t high = node->count;
      while (high - low > 1) {  // the last child that begins at or before the place
        const std::int32_t middle = low + (high - low) / 2;
        if (nodes[at(node->first + middle)].lower <= place) {
          low = middle;
        } else {
          high = middle;
        }
      }
      node = &nodes[at(node->first + low)];
    }
    return node->first;
  }
};

}  // namespace asts
