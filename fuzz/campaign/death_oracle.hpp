#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "properties/statement.hpp"

namespace asts {

/// How code ended that ran in a process of its own.
struct Ending {
  /// Empty when it came back; else one of kDeathKinds.
  std::string kind;
  std::string says;  ///< the signal, or what the exception said

  friend bool operator==(const Ending&, const Ending&) = default;
};

/// How a process ended, by its status from waitpid. REQUIRES: it ended.
Ending ending_of(int status);

/// For a child process: runs `work` and ends the process so that ending_of() tells what happened. `thrown` is told what
/// an exception says. Never returns.
[[noreturn]] void run_and_exit(const std::function<void()>& work,
                               const std::function<void(const std::string&)>& thrown);

/// Whether an ending is likely to come again, and soon: kTimeout takes its time.
bool can_be_tried_again(const std::string& kind);

/// Decides a statement for a case in a process of its own, and tells how that ended.
/// Cost: that of a fork more than the decision, `timeout_seconds` at most. Throws ResourceError without a process.
Ending ending_alone(const Statement& statement, const Case& test_case, std::int64_t timeout_seconds);

}  // namespace asts
