#pragma once

#include <functional>
#include <string>

namespace asts::cli {

/// Sends one line, without a line end, to the process that waits.
using Send = std::function<void(const std::string& line)>;

/// Runs work(0, ...), ..., work(count - 1, ...) at the same time, each in a process of its own, and calls
/// arrived(number, line) for every line that they send, until all have ended. Processes and not threads, because the
/// work may keep what it has computed in static places.
/// An interrupt of this process interrupts them once (see terminal.hpp); how they end is theirs. Throws ResourceError
/// with the reason when one of them throws anything but Interrupted, or dies.
/// REQUIRES: this process has no other threads.
void run_in_processes(int count, const std::function<void(int number, const Send& send)>& work,
                      const std::function<void(int number, const std::string& line)>& arrived);

}  // namespace asts::cli
