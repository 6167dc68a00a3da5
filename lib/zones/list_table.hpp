#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace asts {

/// Lists of numbers, each stored once: equal lists have equal identifiers. Cost: linear in a list's length on average.
class ListTable {
 public:
  ListTable() { clear(); }

  void clear() {
    entries_.clear();
    begin_.assign(1, 0);
    slots_.assign(256, -1);
  }
  std::int32_t size() const { return static_cast<std::int32_t>(begin_.size()) - 1; }
  std::span<const std::int32_t> operator[](std::int32_t id) const {
    const auto i = static_cast<std::size_t>(id);
    return {entries_.data() + begin_[i], begin_[i + 1] - begin_[i]};
  }
  std::int32_t intern(std::span<const std::int32_t> list);

 private:
  std::size_t slot_of(std::span<const std::int32_t> list) const;

  std::vector<std::int32_t> entries_;
  std::vector<std::size_t> begin_;
  std::vector<std::int32_t> slots_;  ///< open addressing, a power of two; -1 is empty
};

}  // namespace asts
