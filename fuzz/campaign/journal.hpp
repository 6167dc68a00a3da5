#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asts {

/// A JSON object as a line that shows whether all of it is there: a last member "check" with a hash of what stands
/// before it (FNV-1a, 64 bits). REQUIRES: an object with a member, without a line end.
std::string sealed(std::string_view object);

/// The object without its seal; nothing when the line is cut or changed.
std::optional<std::string> unsealed(std::string_view line);

/// Reads an append-only file of sealed lines, one after the other. A line counts when all of it is there, with its line
/// end; what is left of a last line is no record.
class JournalReader {
 public:
  /// A file that is not there has no lines.
  explicit JournalReader(std::string path);

  /// The next object; nothing at the end. Throws InputError "FILE:LINE: ..." when a line is damaged and a later one is
  /// not: that is no cut.
  std::optional<std::string> next();

  /// Behind the lines that were read: in bytes from the beginning of the file, and how many they are.
  std::uint64_t end() const { return end_; }
  std::size_t line() const { return line_; }

 private:
  std::optional<std::string> next_line();

  std::string path_;
  std::ifstream file_;
  std::uint64_t end_ = 0;
  std::size_t line_ = 0;
};

/// Writes a journal. What append() has written is on the disk when it returns.
class Journal {
 public:
  /// Keeps the first bytes of the file, and removes the others. Throws InputError when it cannot be opened.
  Journal(std::string path, std::uint64_t bytes);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Throws ResourceError when there is no room.
  void append(std::string_view object);

 private:
  std::string path_;
  int file_;
};

/// Writes a whole file so that at any moment the old or the new one is there. Throws ResourceError.
void replace_file(const std::string& path, std::string_view content);

/// Keeps other programs out of a folder until this process ends. Processes that it starts do not keep the folder
/// locked.
class FolderLock {
 public:
  /// Throws InputError when another program has it.
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

}  // namespace asts
