#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asts {

/// Calls visit(number) for each bit of a word, ascending.
template <typename Visit>
void for_each_bit(std::uint64_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// A set of small numbers as words of bits.
using BitSet = std::span<const std::uint64_t>;

/// Sets of small numbers, one a row.
class BitRows {
 public:
  void reset(std::size_t rows, std::size_t columns) {
    words_ = (columns + 63) / 64;
    bits_.assign(rows * words_, 0);
  }
  bool test(std::size_t row, std::size_t column) const {
    return (bits_[row * words_ + column / 64] >> column % 64 & 1) != 0;
  }
  void set(std::size_t row, std::size_t column) {
    bits_[row * words_ + column / 64] |= std::uint64_t{1} << column % 64;
  }
  void unite(std::size_t row, const BitRows& other, std::size_t other_row) {
    for (std::size_t i = 0; i < words_; ++i) bits_[row * words_ + i] |= other.bits_[other_row * words_ + i];
  }
  BitSet operator[](std::size_t row) const { return {bits_.data() + row * words_, words_}; }
  bool any(std::size_t row) const {
    for (std::size_t i = 0; i < words_; ++i) {
      if (bits_[row * words_ + i] != 0) return true;
    }
    return false;
  }

 private:
  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_;
};

}  // namespace asts
