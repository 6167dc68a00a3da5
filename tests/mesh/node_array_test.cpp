#include "lib/mesh/node_array.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace asts {
namespace {

using Numbers = NodeArray<std::int64_t>;

Numbers counted(std::size_t size) {
  Numbers numbers;
  for (std::size_t i = 0; i < size; ++i) numbers.push_back(static_cast<std::int64_t>(3 * i));
  return numbers;
}

std::size_t wrong(const Numbers& numbers) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) count += numbers[i] == static_cast<std::int64_t>(3 * i) ? 0 : 1;
  return count;
}

// 3 million numbers are 24 MB: the array moves to large pages at 8 MB, and then among them.
TEST(NodeArray, KeepsItsValuesWhileItGrows) {
  for (const std::size_t size : {0, 1, 16, 17, 1048576, 3000000}) {
    const Numbers numbers = counted(size);
    EXPECT_EQ(numbers.size(), size);
    EXPECT_GE(numbers.capacity(), size);
    EXPECT_EQ(wrong(numbers), 0U);
  }
}

TEST(NodeArray, MakesRoomOnceAndThenLeavesValuesInPlace) {
  Numbers numbers = counted(5);
  numbers.reserve(2000000);
  const std::int64_t* const first = &numbers[0];
  numbers.resize_unset(2000000);
  for (std::size_t i = 5; i < numbers.size(); ++i) numbers[i] = static_cast<std::int64_t>(3 * i);
  numbers.reserve(1000);
  EXPECT_EQ(&numbers[0], first);
  EXPECT_EQ(wrong(numbers), 0U);
}

TEST(NodeArray, IsCopiedAndMoved) {
  for (const std::size_t size : {100, 2000000}) {
    Numbers one = counted(size);
    const Numbers copy = one;
    one[0] = 7;
    Numbers moved = std::move(one);
    one = counted(3);
    EXPECT_EQ(moved[0], 7);
    moved = copy;
    EXPECT_EQ(moved.size(), size);
    EXPECT_EQ(wrong(moved) + wrong(copy) + wrong(one), 0U);
  }
}

TEST(NodeArray, CountsItsPages) {
  const std::size_t before = node_array_pages;
  {
    Numbers numbers = counted(100);
    EXPECT_EQ(node_array_pages, before);
    numbers.reserve(2000000);
    const Numbers moved = std::move(numbers);
    EXPECT_EQ(node_array_pages, before + 16777216) << "16,000,000 bytes in pages of 2 MiB";
  }
  EXPECT_EQ(node_array_pages, before);
}

TEST(NodeArray, SaysWhenThereIsNoMemory) {
  Numbers numbers = counted(4);
  EXPECT_THROW(numbers.reserve(std::size_t{1} << 58), std::bad_alloc);
  EXPECT_EQ(wrong(numbers), 0U);
}

}  // namespace
}  // namespace asts
