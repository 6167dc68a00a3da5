#pragma once

#include <cstdint>
#include <vector>

namespace asts {

/// Values for ordered pairs of small identifiers (ranks, vectors, profiles), each computed once. Open addressing: a
/// look-up is one probe mostly.
template <typename Value>
class PairTable {
 public:
  /// The value of (a, b); `compute()` is called when it is not known yet. REQUIRES: a, b >= 0.
  template <typename Compute>
  const Value& get(std::int32_t a, std::int32_t b, const Compute& compute) {
    const std::uint64_t key = static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
    std::size_t slot = slot_of(key);
    if (slots_[slot].key != key) {
      Value value = compute();
      slot = slot_of(key);  // compute() may have used the table
      slots_[slot] = {key, std::move(value)};
      if (2 * ++used_ > slots_.size()) {
        grow();
        slot = slot_of(key);
      }
    }
    return slots_[slot].value;
  }

  /// Forgets all values.
  void clear() {
    slots_.assign(256, Slot{});
    used_ = 0;
  }

 private:
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};
  struct Slot {
    std::uint64_t key = kEmpty;
    Value value{};
  };

  std::size_t slot_of(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = (key * 0x9E3779B97F4A7C15ull ^ key >> 32) * 0xD6E8FEB86659FD93ull >> 24 & mask;
    while (slots_[slot].key != kEmpty && slots_[slot].key != key) slot = (slot + 1) & mask;
    return slot;
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (Slot& slot : old) {
      if (slot.key != kEmpty) slots_[slot_of(slot.key)] = std::move(slot);
    }
  }

  std::vector<Slot> slots_ = std::vector<Slot>(256);
  std::size_t used_ = 0;
};

}  // namespace asts
