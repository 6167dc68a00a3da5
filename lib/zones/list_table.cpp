#include "lib/zones/list_table.hpp"

#include <algorithm>

namespace asts {

std::size_t ListTable::slot_of(std::span<const std::int32_t> list) const {
  std::uint64_t hash = list.size();
  for (const std::int32_t entry : list) {
    hash = (hash ^ static_cast<std::uint32_t>(entry)) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 32;
  }
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash & mask;
  while (slots_[slot] >= 0 && !std::ranges::equal((*this)[slots_[slot]], list)) slot = (slot + 1) & mask;
  return slot;
}

std::int32_t ListTable::intern(std::span<const std::int32_t> list) {
  const std::size_t slot = slot_of(list);
  if (slots_[slot] >= 0) return slots_[slot];
  const std::int32_t id = size();
  entries_.insert(entries_.end(), list.begin(), list.end());
  begin_.push_back(entries_.size());
  slots_[slot] = id;
  if (2 * begin_.size() > slots_.size()) {
    slots_.assign(2 * slots_.size(), -1);
    for (std::int32_t i = 0; i < size(); ++i) slots_[slot_of((*this)[i])] = i;
  }
  return id;
}

}  // namespace asts
