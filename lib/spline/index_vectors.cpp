#include "lib/spline/index_vectors.hpp"

#include <algorithm>

namespace asts {

std::size_t IndexVectors::slot_of(std::span<const std::int32_t> vector) const {
  std::uint64_t hash = 0x9E3779B97F4A7C15ull;
  for (const std::int32_t entry : vector) hash = (hash ^ static_cast<std::uint32_t>(entry)) * 0xFF51AFD7ED558CCDull;
  hash ^= hash >> 32;
  std::size_t slot = hash & (table_.size() - 1);
  while (table_[slot] >= 0 && !std::equal(vector.begin(), vector.end(), (*this)[table_[slot]].begin())) {
    slot = (slot + 1) & (table_.size() - 1);
  }
  return slot;
}

std::int32_t IndexVectors::intern(std::span<const std::int32_t> vector) {
  const std::size_t slot = slot_of(vector);
  if (table_[slot] >= 0) return table_[slot];
  const std::int32_t id = size();
  entries_.insert(entries_.end(), vector.begin(), vector.end());
  table_[slot] = id;
  if (2 * static_cast<std::size_t>(size()) > table_.size()) grow();
  return id;
}

void IndexVectors::grow() {
  table_.assign(2 * table_.size(), -1);
  for (std::int32_t id = 0; id < size(); ++id) table_[slot_of((*this)[id])] = id;
}

bool overlap(std::span<const std::int32_t> one, std::span<const std::int32_t> other) {
  const std::int32_t lower = std::max(one.front(), other.front());
  const std::int32_t upper = std::min(one.back(), other.back());
  auto i = std::lower_bound(one.begin(), one.end(), lower);
  auto j = std::lower_bound(other.begin(), other.end(), lower);
  while (i != one.end() && j != other.end() && *i <= upper && *j <= upper) {
    if (*i++ != *j++) return false;
  }
  const bool one_done = i == one.end() || *i > upper;
  const bool other_done = j == other.end() || *j > upper;
  return one_done && other_done;
}

void append_missing(std::span<const std::int32_t> one, std::span<const std::int32_t> other,
                    std::vector<std::int32_t>& result) {
  for (const std::int32_t entry : one) {
    if (entry < other.front() || entry > other.back()) continue;
    if (!std::binary_search(other.begin(), other.end(), entry)) result.push_back(entry);
  }
}

}  // namespace asts
