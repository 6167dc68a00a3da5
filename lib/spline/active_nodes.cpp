#include "lib/spline/active_nodes.hpp"

#include <numeric>

namespace asts {

namespace {

/// Finds nodes by position: open addressing over the nodes found so far.
class NodeTable {
 public:
  explicit NodeTable(ActiveNodes& nodes) : nodes_(nodes), slots_(1024, -1) {}

  std::size_t find_or_add(const PerAxis<std::int32_t>& position) {
    std::size_t slot = slot_of(position);
    if (slots_[slot] < 0) {
      slots_[slot] = static_cast<std::int32_t>(nodes_.positions.size());
      nodes_.positions.push_back(position);
      nodes_.beside.emplace_back().fill(-1);
      if (4 * nodes_.positions.size() > slots_.size()) {
        grow();
        slot = slot_of(position);
      }
    }
    return at(slots_[slot]);
  }

 private:
  /// Nodes of a block of 4 ranks an axis have neighbouring slots, so that nodes of neighbouring elements, which come
  /// one after the other, are found in the same cache lines and pages; the table is kept sparse for it.
  std::size_t slot_of(const PerAxis<std::int32_t>& position) const {
    std::uint64_t block = 0;
    std::uint64_t inside = 0;
    for (const std::int32_t rank : position) {
      block = (block + static_cast<std::uint32_t>(rank >> 2)) * 0x9E3779B97F4A7C15ull;
      inside = inside << 2 | static_cast<std::uint32_t>(rank & 3);
    }
    std::size_t slot = (((block ^ block >> 32) * 0xBF58476D1CE4E5B9ull >> 20) + inside) & (slots_.size() - 1);
    while (slots_[slot] >= 0 && nodes_.positions[at(slots_[slot])] != position) slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow() {
    slots_.assign(4 * slots_.size(), -1);
    for (std::size_t i = 0; i < nodes_.positions.size(); ++i) {
      slots_[slot_of(nodes_.positions[i])] = static_cast<std::int32_t>(i);
    }
  }

  ActiveNodes& nodes_;
  std::vector<std::int32_t> slots_;
};

/// Gathers the vertices in the active region, in the order of the elements.
ActiveNodes collect(const Mesh& mesh, const ActiveRegion& region) {
  ActiveNodes nodes;
  nodes.positions.reserve(mesh.elements.size());  // a guess that is about right for fine meshes
  nodes.beside.reserve(mesh.elements.size());
  NodeTable table(nodes);
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    const Box& box = mesh.elements[element];
    std::size_t below = 0;  // bit a: the element's lower side along axis a lies in the active region
    std::size_t above = 0;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      below |= std::size_t{region.contains(axis, 2 * box.lower[at(axis)])} << axis;
      above |= std::size_t{region.contains(axis, 2 * box.upper[at(axis)])} << axis;
    }
    if ((below | above) != ActiveNodes::kOctants - 1) continue;
    for (std::size_t corner = 0; corner < ActiveNodes::kOctants; ++corner) {
      // seen from an upper corner the element lies below, and the other way round
      const std::size_t octant = ~corner & (ActiveNodes::kOctants - 1);
      if (((corner & above) | (octant & below)) != ActiveNodes::kOctants - 1) continue;
      PerAxis<std::int32_t> position;
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        position[axis] = (corner >> axis & 1) != 0 ? box.upper[axis] : box.lower[axis];
      }
      nodes.beside[table.find_or_add(position)][octant] = static_cast<std::int32_t>(element);
    }
  }
  return nodes;
}

}  // namespace

void stable_sort_by_axis(const Mesh& mesh, const std::vector<PerAxis<std::int32_t>>& positions, Axis axis,
                         std::vector<std::int32_t>& order) {
  std::vector<std::size_t> begin(mesh.coordinates[at(axis)].size() + 1, 0);
  for (const PerAxis<std::int32_t>& position : positions) ++begin[at(position[at(axis)]) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::int32_t> sorted(order.size());
  for (const std::int32_t node : order) sorted[begin[at(positions[at(node)][at(axis)])]++] = node;
  order = std::move(sorted);
}

ActiveNodes active_nodes(const Mesh& mesh, const ActiveRegion& region) {
  if (region.empty) return {};
  const ActiveNodes found = collect(mesh, region);
  std::vector<std::int32_t> order(found.positions.size());
  std::iota(order.begin(), order.end(), 0);
  for (Axis axis = kDimension - 1; axis >= 0; --axis) stable_sort_by_axis(mesh, found.positions, axis, order);
  ActiveNodes nodes;
  nodes.positions.reserve(order.size());
  nodes.beside.reserve(order.size());
  for (const std::int32_t node : order) {
    nodes.positions.push_back(found.positions[at(node)]);
    nodes.beside.push_back(found.beside[at(node)]);
  }
  return nodes;
}

}  // namespace asts
