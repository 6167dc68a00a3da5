#include "lib/threads/parallel_for.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace asts {

namespace {

class Shared {
 public:
  Shared(std::size_t count, const std::function<void(std::size_t, int)>& work) : count_(count), work_(work) {}

  void run(int worker) {
    while (!failed_) {  // asked before an item is taken: all items below a failed one are done
      const std::size_t item = next_++;
      if (item >= count_) return;
      try {
        work_(item, worker);
      } catch (...) {
        keep(item, std::current_exception());
      }
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void keep(std::size_t item, std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (failure_ && failed_item_ < item) return;
    failure_ = std::move(failure);
    failed_item_ = item;
    failed_ = true;
  }

  const std::size_t count_;
  const std::function<void(std::size_t, int)>& work_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::size_t failed_item_ = 0;
};

}  // namespace

void parallel_for(int jobs, std::size_t count, const std::function<void(std::size_t item, int worker)>& work) {
  Shared shared(count, work);
  const int others = static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(jobs), count)) - 1;
  std::vector<std::jthread> threads;
  for (int worker = 1; worker <= others; ++worker) {
    threads.emplace_back([&shared, worker] { shared.run(worker); });
  }
  shared.run(0);
  threads.clear();  // waits for them
  shared.rethrow();
}

}  // namespace asts
