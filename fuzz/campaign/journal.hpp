#pragma once

#include <cstddef>
#include <cstdint>
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

/// An append-only file of sealed lines. A line counts when all of it is there, with its line end.
struct JournalContent {
  std::vector<std::string> objects;
  std::vector<std::uint64_t> ends;  ///< of each line, in bytes from the beginning of the file
};

/// Reads a journal; empty when there is no file. What is left of a last line is no record.
/// Throws InputError "FILE:LINE: ..." when a line is damaged and a later one is not: that is no cut.
JournalContent read_journal(const std::string& path);

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
