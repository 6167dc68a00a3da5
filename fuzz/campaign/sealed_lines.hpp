#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "fuzz/campaign/journal.hpp"

namespace asts {

/// The lines of a journal that is complete: for reading alone, where what a campaign would do again is an error.
class SealedLines {
 public:
  /// Throws InputError when the file cannot be read.
  explicit SealedLines(const std::string& path);

  /// The next object; nothing at the end. Throws InputError "FILE:LINE: ..." for a line that is cut off or damaged.
  std::optional<std::string> next();

  /// Calls what takes the line that was read last; an InputError or an error of JSON gets the file and the line.
  void at_this_line(const std::function<void()>& take) const;

 private:
  std::string path_;
  std::uint64_t size_;
  JournalReader lines_;
};

/// All of a file. Throws InputError when it cannot be read.
std::string content_of_file(const std::string& path);

/// The JSON value that a file is. Throws InputError "FILE:LINE: ..." when it cannot be read or is none.
nlohmann::ordered_json json_of_file(const std::string& path);

}  // namespace asts
