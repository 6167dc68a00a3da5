#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Runs the program as its users do: as a process of its own, without a shell in between.
namespace asts::testing {

/// A folder that is there as long as the object is.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "asts-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string path(const std::string& name) const { return (path_ / name).string(); }

  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

 private:
  std::filesystem::path path_;
};

inline std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

struct Outcome {
  int exit_code;  ///< 128 + signal when a signal ended it, as a shell says it
  std::string out;
  std::string err;
};

/// A running program. Its output goes into files of the folder, so that no pipe can fill up.
class Process {
 public:
  explicit Process(std::vector<std::string> arguments, const std::string& input = {},
                   const std::string& directory = {}) {
    const std::string stdin_path = folder_.write("stdin", input);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, stdin_path.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, out_path().c_str(), O_WRONLY | O_CREAT, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, err_path().c_str(), O_WRONLY | O_CREAT, 0600);
    if (!directory.empty()) posix_spawn_file_actions_addchdir_np(&actions, directory.c_str());
    arguments.insert(arguments.begin(), ASTS_PROGRAM);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const int failure = posix_spawn(&id_, ASTS_PROGRAM, &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) throw std::runtime_error("the program cannot be started: " ASTS_PROGRAM);
  }

  pid_t id() const { return id_; }
  std::string out_so_far() const { return content_of(out_path()); }

  Outcome wait() {
    int status = 0;
    waitpid(id_, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content_of(out_path()),
            content_of(err_path())};
  }

 private:
  std::string out_path() const { return folder_.path("stdout"); }
  std::string err_path() const { return folder_.path("stderr"); }

  TemporaryFolder folder_;
  pid_t id_ = 0;
};

inline Outcome run(std::vector<std::string> arguments, const std::string& input = {},
                   const std::string& directory = {}) {
  return Process(std::move(arguments), input, directory).wait();
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// One object a line; throws when a line is none.
inline std::vector<nlohmann::ordered_json> records_of(const std::string& text) {
  std::vector<nlohmann::ordered_json> records;
  for (const std::string& line : lines_of(text)) records.push_back(nlohmann::ordered_json::parse(line));
  return records;
}

inline std::vector<std::string> keys_of(const nlohmann::ordered_json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

inline std::string case_path(const std::string& name) { return std::string(ASTS_CASES) + "/" + name; }

/// All case files under tests/cases, in alphabetical order.
inline std::vector<std::string> all_case_paths() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ASTS_CASES)) {
    if (entry.path().extension() == ".case") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// The beginning of a case of degree 3 and grading 2 on 4 x 4 x 4 unit cubes: one active node, (2, 2, 2).
inline const std::string kHeader = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n";

}  // namespace asts::testing
