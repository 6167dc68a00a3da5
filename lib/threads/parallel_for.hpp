#pragma once

#include <cstddef>
#include <functional>

namespace asts {

/// Calls work(item, worker) for every item of 0, ..., count - 1, each once. `jobs` threads, the caller's own among
/// them, take the next item that is left; worker is the thread's number, 0, ..., jobs - 1, for what a thread keeps to
/// itself. Returns when all are done. When calls throw, no new item is begun, and the exception of the least item is
/// thrown here. With one job, or one item, no thread is made and the items come in their order. REQUIRES: jobs >= 1;
/// calls for different items do not write to the same place.
void parallel_for(int jobs, std::size_t count, const std::function<void(std::size_t item, int worker)>& work);

}  // namespace asts
