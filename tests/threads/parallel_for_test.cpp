#include "lib/threads/parallel_for.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace asts {
namespace {

TEST(ParallelFor, DoesEveryItemOnce) {
  for (const int jobs : {1, 2, 5}) {
    for (const std::size_t count : {0u, 1u, 3u, 1000u}) {
      std::vector<std::atomic<int>> done(count);
      std::atomic<bool> strange{false};
      parallel_for(jobs, count, [&](std::size_t item, int worker) {
        ++done[item];
        if (worker < 0 || worker >= jobs) strange = true;
      });
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(done[i], 1) << i;
      EXPECT_FALSE(strange);
    }
  }
}

TEST(ParallelFor, KeepsTheOrderWithOneJob) {
  std::vector<std::size_t> order;
  parallel_for(1, 4, [&](std::size_t item, int) { order.push_back(item); });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(ParallelFor, ThrowsWhatTheLeastItemThrew) {
  for (const int jobs : {1, 3}) {
    std::atomic<int> begun{0};
    const auto run = [&] {
      parallel_for(jobs, 100000, [&](std::size_t item, int) {
        ++begun;
        if (item >= 2) throw std::runtime_error(item == 2 ? "two" : "another");
      });
    };
    try {
      run();
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()), "two");
    }
    EXPECT_LT(begun, 100000);
  }
}

}  // namespace
}  // namespace asts
