#pragma once

namespace asts {

/// What a thread keeps to itself and writes to all the time, where that of another thread stands beside it: alone in
/// its lines of the cache, of which processors fetch two at a time. Threads that write to one line wait for each other.
template <typename T>
struct alignas(128) Apart {
  T own;
};

}  // namespace asts
