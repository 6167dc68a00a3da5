#include "fuzz/campaign/death_oracle.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

/// Exit codes of a child that tell what it met. The program's own are below 10 and 130.
constexpr int kMemoryCode = 41;
constexpr int kExceptionCode = 42;
/// A decision that takes longer is no crash.
constexpr unsigned kLongestSeconds = 60;

}  // namespace

Ending ending_of(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return {signal == SIGALRM ? "timeout" : "crash",
            std::string("signal ") + std::to_string(signal) + " (" + strsignal(signal) + ")"};
  }
  const int code = WEXITSTATUS(status);
  if (code == 0) return {};
  if (code == kMemoryCode) return {"memory", "no memory within the limit"};
  if (code == kExceptionCode) return {"exception", {}};
  return {"crash", "exit code " + std::to_string(code)};
}

void run_and_exit(const std::function<void()>& work, const std::function<void(const std::string&)>& thrown) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    std::_Exit(kMemoryCode);
  } catch (const std::exception& error) {
    thrown(error.what());
    std::_Exit(kExceptionCode);
  }
  std::_Exit(0);
}

bool can_be_tried_again(const std::string& kind) { return kind == "crash" || kind == "exception"; }

std::optional<std::string> death_of(const Statement& statement, const Case& test_case, const std::string& kind) {
  const pid_t child = fork();
  if (child < 0) throw ResourceError("no other process");
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    alarm(kLongestSeconds);
    run_and_exit([&] { try_on_case(statement, test_case); }, [](const std::string&) {});
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const std::string ended = ending_of(status).kind;
  return ended == kind ? std::optional(ended) : std::nullopt;
}

}  // namespace asts
