#pragma once

#include <cstddef>
#include <functional>

namespace asts {

/// Delta debugging: removes chunks of a list, all of it, halves, quarters, ..., single entries, wherever `remove`
/// agrees. `count` gives the number of entries, which a removal changes; `remove` takes the first entry and how many,
/// and says whether they are gone. Returns whether any are.
inline bool drop_chunks(const std::function<std::size_t()>& count,
                        const std::function<bool(std::size_t first, std::size_t entries)>& remove) {
  bool any = false;
  for (std::size_t size = count(); size > 0;) {
    bool some = false;
    for (std::size_t first = 0; first < count();) {
      const std::size_t entries = std::min(size, count() - first);
      const bool removed = remove(first, entries);
      some = some || removed;
      if (!removed) first += entries;
    }
    any = any || some;
    const std::size_t divisor = some || size < 8 ? 2 : 4;
    size /= divisor;
  }
  return any;
}

}  // namespace asts
