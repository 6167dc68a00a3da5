#include "cli/processes.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"

namespace asts::cli {

namespace {

using Work = std::function<void(int number, const Send& send)>;

/// Marks a line that is the reason of a failure.
constexpr char kFailed = '!';
constexpr int kPollMilliseconds = 200;

struct Process {
  pid_t id = 0;
  int lines = -1;    ///< where they arrive; -1 when it has ended
  std::string rest;  ///< of a line that is not complete
};

void write_line(int file, const std::string& line) {
  const std::string bytes = line + "\n";
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write(file, bytes.data() + done, bytes.size() - done);
    if (written < 0) throw ResourceError("a line cannot be sent");
    done += static_cast<std::size_t>(written);
  }
}

[[noreturn]] void run_child(int number, int file, const Work& work) {
  // a group of its own: an interrupt from the terminal reaches the one that waits, which hands it on
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  int code = kHolds;
  try {
    work(number, [file](const std::string& line) { write_line(file, line); });
  } catch (const Interrupted&) {
    code = kInterrupted;
  } catch (const std::exception& error) {
    code = kFailure;
    std::string reason = error.what();
    for (char& c : reason) c = c == '\n' ? '\t' : c;
    try {
      write_line(file, kFailed + reason);
    } catch (const ResourceError&) {
    }
  }
  std::_Exit(code);
}

Process start(int number, const Work& work) {
  int ends[2];
  if (pipe(ends) != 0) throw ResourceError("no pipe for another process");
  std::fflush(nullptr);
  const pid_t id = fork();
  if (id < 0) throw ResourceError("no other process");
  if (id == 0) {
    close(ends[0]);
    run_child(number, ends[1], work);
  }
  close(ends[1]);
  return {id, ends[0], {}};
}

/// Takes what has arrived; false at the end.
bool take(Process& process, const std::function<void(const std::string&)>& arrived) {
  char buffer[1 << 16];
  const ssize_t count = read(process.lines, buffer, sizeof buffer);
  if (count <= 0) return false;
  process.rest.append(buffer, static_cast<std::size_t>(count));
  for (std::size_t end; (end = process.rest.find('\n')) != std::string::npos; process.rest.erase(0, end + 1)) {
    arrived(process.rest.substr(0, end));
  }
  return true;
}

bool is_interrupted() {
  try {
    stop_if_interrupted();
  } catch (const Interrupted&) {
    return true;
  }
  return false;
}

/// Whether the process ended well, or because of an interrupt.
bool ended_well(pid_t id) {
  int status = 0;
  if (waitpid(id, &status, 0) != id || !WIFEXITED(status)) return false;
  return WEXITSTATUS(status) == kHolds || WEXITSTATUS(status) == kInterrupted;
}

}  // namespace

void run_in_processes(int count, const Work& work,
                      const std::function<void(int number, const std::string& line)>& arrived) {
  std::vector<Process> processes;
  for (int number = 0; number < count; ++number) processes.push_back(start(number, work));
  std::string reason;
  bool handed_on = false;
  for (int running = count; running > 0;) {
    if (!handed_on && is_interrupted()) {
      handed_on = true;
      for (const Process& process : processes) kill(process.id, SIGINT);
    }
    std::vector<pollfd> waiting;
    for (const Process& process : processes) waiting.push_back({process.lines, POLLIN, 0});
    if (poll(waiting.data(), waiting.size(), kPollMilliseconds) <= 0) continue;
    for (int number = 0; number < count; ++number) {
      Process& process = processes[static_cast<std::size_t>(number)];
      if (waiting[static_cast<std::size_t>(number)].revents == 0) continue;
      const auto keep = [&](const std::string& line) {
        if (line.starts_with(kFailed)) {
          reason = line.substr(1);
        } else {
          arrived(number, line);
        }
      };
      if (take(process, keep)) continue;
      close(process.lines);
      process.lines = -1;
      --running;
      if (!ended_well(process.id) && reason.empty()) reason = "another process ended without a word";
    }
  }
  if (!reason.empty()) throw ResourceError(reason);
}

}  // namespace asts::cli
