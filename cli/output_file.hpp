#pragma once

#include <fstream>
#include <string>

namespace asts::cli {

/// Whether two paths lead to one file that is there, by whatever links: what is read must not be written over.
bool same_file(const std::string& path, const std::string& other);

/// A file that appears whole or not at all: it is written beside its place and renamed at the end, so that an interrupt
/// never leaves half a file, nor harms an old one. A device or a pipe is written to directly.
class OutputFile {
 public:
  /// Throws InputError when the file cannot be opened: before the work, and before anything is on stdout.
  explicit OutputFile(const std::string& path);
  /// Removes what was written, unless finish() was called.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writes all of the file. Throws ResourceError when there is no room for it.
  void finish(const std::string& text);

 private:
  std::string path_;
  std::string written_;  ///< the name while writing
  std::ofstream file_;
  bool finished_ = false;
};

}  // namespace asts::cli
