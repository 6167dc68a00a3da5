#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// time_processes ROUNDS NAME COMMAND... [-- NAME COMMAND...]...
/// Runs commands one after the other, all of them in each round, so that what the machine does otherwise hits them
/// alike. Prints one JSON object a command: {"name", "seconds": [one a round], "cpu_seconds": [...], "peak_kilobytes":
/// the largest, "exit_code": the last}. What the commands print goes nowhere.
namespace {

struct Command {
  std::string name;
  std::vector<std::string> arguments;
  std::vector<double> seconds;
  std::vector<double> cpu_seconds;
  long peak_kilobytes = 0;
  int exit_code = 0;
};

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
}

std::vector<Command> commands_of(const std::vector<std::string>& words) {
  std::vector<Command> commands;
  bool begins = true;
  for (const std::string& word : words) {
    if (word == "--") {
      begins = true;
    } else if (begins) {
      commands.push_back({word, {}, {}, {}});
      begins = false;
    } else {
      commands.back().arguments.push_back(word);
    }
  }
  return commands;
}

pid_t start(const Command& command) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::vector<std::string> arguments = command.arguments;
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  pid_t id = 0;
  const int failure = posix_spawnp(&id, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) {
    std::cerr << "time_processes: " << command.name << " cannot be started\n";
    std::exit(2);
  }
  return id;
}

void run(Command& command) {
  const auto begin = std::chrono::steady_clock::now();
  const pid_t id = start(command);
  int status = 0;
  rusage usage{};
  wait4(id, &status, 0, &usage);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  command.seconds.push_back(elapsed.count());
  command.cpu_seconds.push_back(seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime));
  command.peak_kilobytes = std::max(command.peak_kilobytes, usage.ru_maxrss);
  command.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 0;
  std::vector<Command> commands = commands_of({argv + std::min(argc, 2), argv + argc});
  const bool complete = !commands.empty() && std::none_of(commands.begin(), commands.end(), [](const Command& command) {
    return command.arguments.empty();
  });
  if (rounds < 1 || !complete) {
    std::cerr << "usage: time_processes ROUNDS NAME COMMAND... [-- NAME COMMAND...]...\n";
    return 2;
  }
  for (int round = 0; round < rounds; ++round) {
    for (Command& command : commands) run(command);
  }
  for (const Command& command : commands) {
    std::cout << nlohmann::ordered_json{{"name", command.name},
                                        {"seconds", command.seconds},
                                        {"cpu_seconds", command.cpu_seconds},
                                        {"peak_kilobytes", command.peak_kilobytes},
                                        {"exit_code", command.exit_code}}
                     .dump()
              << '\n';
  }
  return 0;
}
