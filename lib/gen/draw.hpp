#pragma once

#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace asts {

/// Random integers from a seed. The stream of std::mt19937_64 is fixed by the C++ standard and the integers are drawn
/// from it here, not by the standard library's distributions, which differ between libraries: so that a seed means the
/// same case everywhere.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  /// Each of first..last with the same probability. REQUIRES: first <= last, last - first < 2^63.
  std::int64_t between(std::int64_t first, std::int64_t last) {
    const std::uint64_t count = static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first) + 1;
    // the highest 2^64 mod count values would favour small results: they are drawn again
    const std::uint64_t surplus = (std::numeric_limits<std::uint64_t>::max() % count + 1) % count;
    std::uint64_t bits = engine_();
    while (bits > std::numeric_limits<std::uint64_t>::max() - surplus) bits = engine_();
    return first + static_cast<std::int64_t>(bits % count);
  }

  int between(int first, int last) { return static_cast<int>(between(std::int64_t{first}, std::int64_t{last})); }

  /// True once in n times.
  bool one_in(int n) { return between(1, n) == 1; }

  /// A place in a list. REQUIRES: count >= 1.
  std::size_t index(std::size_t count) {
    return static_cast<std::size_t>(between(std::int64_t{0}, static_cast<std::int64_t>(count) - 1));
  }

  /// REQUIRES: not empty.
  template <typename T>
  const T& choose(const std::vector<T>& values) {
    return values[index(values.size())];
  }

  /// Every order with the same probability.
  template <typename T>
  void shuffle(std::vector<T>& values) {
    for (std::size_t last = values.size(); last > 1; --last) std::swap(values[last - 1], values[index(last)]);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace asts
