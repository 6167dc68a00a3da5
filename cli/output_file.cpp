#include "cli/output_file.hpp"

#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "lib/exact/errors.hpp"

namespace asts::cli {

namespace {

/// A device must not be replaced by a file.
bool is_special(const std::string& path) {
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(path, none);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
         !std::filesystem::is_directory(status);
}

}  // namespace

bool same_file(const std::string& path, const std::string& other) {
  std::error_code missing;
  return std::filesystem::equivalent(path, other, missing);
}

OutputFile::OutputFile(const std::string& path)
    : path_(path), written_(is_special(path) ? path : path + ".part" + std::to_string(getpid())) {
  if (std::filesystem::is_directory(path)) throw InputError(path + ": cannot be written: is a directory");
  file_.open(written_, std::ios::binary | std::ios::trunc);
  if (!file_) throw InputError(path + ": cannot be written");
}

OutputFile::~OutputFile() {
  if (!finished_ && written_ != path_) std::remove(written_.c_str());
}

void OutputFile::finish(const std::string& text) {
  file_ << text;
  file_.close();
  if (!file_ || (written_ != path_ && std::rename(written_.c_str(), path_.c_str()) != 0)) {
    throw ResourceError(path_ + ": could not be written to its end");
  }
  finished_ = true;
}

}  // namespace asts::cli
