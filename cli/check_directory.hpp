#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "cli/input.hpp"
#include "reports/html/check_page.hpp"

namespace asts::cli {

/// The run directory of `asts check --out DIR`:
///   check.json       version, options, and the cases with their files;
///   records.jsonl    a record a mesh, as `--format json` prints it;
///   cases/N-NAME     the cases as text, numbered from 1.
/// A function of the cases and the options, but for how far an interrupted run came.
class CheckDirectory {
 public:
  /// Makes the folder if there is none, and writes all but the records. Throws InputError when it cannot be written, or
  /// has something in it already.
  CheckDirectory(const std::string& folder, const CheckRun& run, const std::vector<Input>& inputs);

  /// Writes a record's line. Throws ResourceError when there is no room.
  void add(const std::string& line);

 private:
  std::string path_;
  std::ofstream records_;
};

/// Whether a folder is one.
bool has_check(const std::string& folder);

/// All that such a folder records. Throws InputError "FILE:LINE: reason" for a record that is cut off, of another
/// shape, or not the next one of the cases and options, "FILE: reason" where no line is at fault.
CheckRun read_check_directory(const std::string& folder);

}  // namespace asts::cli
