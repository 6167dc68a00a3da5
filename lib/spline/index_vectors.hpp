#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asts {

/// The local index vectors of one axis (Definition 4.4), each stored once: equal vectors have equal identifiers.
/// A vector is p+2 strictly ascending ranks. Cost of interning: constant on average, memory linear in distinct vectors.
class IndexVectors {
 public:
  explicit IndexVectors(int degree) : length_(static_cast<std::size_t>(degree) + 2), table_(64, -1) {}

  std::size_t length() const { return length_; }
  std::int32_t size() const { return static_cast<std::int32_t>(entries_.size() / length_); }
  std::span<const std::int32_t> operator[](std::int32_t id) const {
    return {entries_.data() + static_cast<std::size_t>(id) * length_, length_};
  }
  std::int32_t front(std::int32_t id) const { return entries_[static_cast<std::size_t>(id) * length_]; }
  std::int32_t back(std::int32_t id) const { return entries_[static_cast<std::size_t>(id) * length_ + length_ - 1]; }

  /// The identifier of a vector, new or old. REQUIRES: vector.size() == length().
  std::int32_t intern(std::span<const std::int32_t> vector);

 private:
  std::size_t slot_of(std::span<const std::int32_t> vector) const;
  void grow();

  std::size_t length_;
  std::vector<std::int32_t> entries_;
  std::vector<std::int32_t> table_;  ///< open addressing, a power of two; -1 is empty
};

/// Equation (6.1): every entry of either vector that lies in the other's closed range is an entry of the other.
/// REQUIRES: both ascend strictly. Cost: linear in the lengths.
bool overlap(std::span<const std::int32_t> one, std::span<const std::int32_t> other);

/// The entries of `one` that lie in the closed range of `other` and are no entries of `other`: what keeps the two from
/// overlapping, from one side. Appended to `result`, ascending.
void append_missing(std::span<const std::int32_t> one, std::span<const std::int32_t> other,
                    std::vector<std::int32_t>& result);

}  // namespace asts
