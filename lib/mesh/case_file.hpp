#pragma once

#include <string>
#include <string_view>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case.hpp"

namespace asts {

/// Something is wrong with a case file: what() is "FILE:LINE: reason" (or "FILE: reason" where no line is at fault).
struct CaseFileError : InputError {
  using InputError::InputError;
};

/// Reads a case in the text format of the interface contract, version 1. `name` stands for the file in messages.
/// Throws CaseFileError that names the first line at fault. Does not check that element boxes tile the domain (the
/// mesh that is built of them does), but that each is a non-empty box inside the domain, and that marks lie in the
/// domain. Cost: linear in the text.
Case parse_case(std::string_view text, const std::string& name);

/// Reads the file, or standard input for "-". Throws CaseFileError when it is missing, a directory, unreadable, or
/// not a case.
Case read_case_file(const std::string& path);

/// The canonical text of a case: parse_case gives an equal case back, and equal cases give equal bytes.
std::string write_case(const Case& test_case);

}  // namespace asts
