#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace asts {

/// Numbers nodes of a tree 0, 1, 2, ... in the order in which they come. Open addressing; memory and time are linear
/// in the nodes numbered, whatever the size of the tree.
class NodeTable {
 public:
  static constexpr std::int32_t kNone = -1;

  std::int32_t size() const { return static_cast<std::int32_t>(nodes_.size()); }
  std::int32_t node(std::int32_t number) const { return nodes_[static_cast<std::size_t>(number)]; }

  /// The number of a node, kNone when it has none. REQUIRES: node >= 0.
  std::int32_t find(std::int32_t node) const { return slots_[slot_of(node)].number; }

  bool contains(std::int32_t node) const { return find(node) != kNone; }

  /// The number of a node, and whether it is new.
  std::pair<std::int32_t, bool> insert(std::int32_t node) {
    std::size_t slot = slot_of(node);
    if (slots_[slot].node == node) return {slots_[slot].number, false};
    if (2 * (nodes_.size() + 1) > slots_.size()) {
      grow();
      slot = slot_of(node);
    }
    slots_[slot] = {node, size()};
    nodes_.push_back(node);
    return {size() - 1, true};
  }

 private:
  struct Slot {
    std::int32_t node = kNone;
    std::int32_t number = kNone;
  };

  std::size_t slot_of(std::int32_t node) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = static_cast<std::uint64_t>(node) * 0x9E3779B97F4A7C15U >> 32U & mask;
    while (slots_[slot].node != kNone && slots_[slot].node != node) slot = (slot + 1) & mask;
    return slot;
  }

  void grow() {
    slots_.assign(2 * slots_.size(), {});
    for (std::int32_t number = 0; number < size(); ++number) slots_[slot_of(node(number))] = {node(number), number};
  }

  std::vector<Slot> slots_ = std::vector<Slot>(64);
  std::vector<std::int32_t> nodes_;
};

}  // namespace asts
