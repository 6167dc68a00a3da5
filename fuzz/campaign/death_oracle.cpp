#include "fuzz/campaign/death_oracle.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "lib/exact/errors.hpp"
#include "properties/campaign/summary.hpp"

namespace asts {

namespace {

/// Exit codes of a child that tell what it met. The program's own are below 10 and 130.
constexpr int kMemoryCode = 41;
constexpr int kExceptionCode = 42;

/// No more than a pipe takes at once.
constexpr std::size_t kMostWords = 4000;

void write_words(int file, const std::string& words) {
  // what cannot be sent is missing in a message, no more
  [[maybe_unused]] const ssize_t written = write(file, words.data(), std::min(words.size(), kMostWords));
}

/// Until the other side ends.
std::string read_words(int file) {
  std::string words;
  char buffer[kMostWords];
  while (true) {
    const ssize_t count = read(file, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return words;
    words.append(buffer, static_cast<std::size_t>(count));
  }
}

}  // namespace

Ending ending_of(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return {signal == SIGALRM ? kTimeout : kCrash,
            std::string("signal ") + std::to_string(signal) + " (" + strsignal(signal) + ")"};
  }
  const int code = WEXITSTATUS(status);
  if (code == 0) return {};
  if (code == kMemoryCode) return {kOutOfMemory, "no memory within the limit"};
  if (code == kExceptionCode) return {kException, {}};
  return {kCrash, "exit code " + std::to_string(code)};
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

bool can_be_tried_again(const std::string& kind) { return kind == kCrash || kind == kException; }

Ending ending_alone(const Statement& statement, const Case& test_case, std::int64_t timeout_seconds) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw ResourceError("no line to another process");
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) throw ResourceError("no other process");
  if (child == 0) {
    close(ends[0]);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) std::_Exit(0);
    alarm(static_cast<unsigned>(timeout_seconds));
    run_and_exit([&] { try_on_case(statement, test_case); },
                 [&](const std::string& says) { write_words(ends[1], says); });
  }
  close(ends[1]);
  const std::string says = read_words(ends[0]);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  Ending ending = ending_of(status);
  if (ending.kind == kException) ending.says = says;
  return ending;
}

}  // namespace asts
