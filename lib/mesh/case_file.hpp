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
/// domain. All comparisons are exact. Line ends may be LF or CRLF, the last one may be missing, and a UTF-8 byte
/// order mark at the beginning is skipped. A size such as `grading 4/2` is the integer 2.
///
/// Example, where both marks of the one step are in [0,4] x [0,4] x [0,5]:
///
///     asts-case 1
///     degree 3 3 3            # degree, grading and domain in any order, each once
///     grading 2
///     domain 4 4 5
///     refine 1/4 1/4 1/4  5/2 1/2 1/2
///
/// Laws (tests/mesh/case_round_trip_test.cpp):
///  1. parse_case(write_case(c)) == c for every case c that parse_case can give;
///  2. blanks, free lines and comments mean nothing;
///  3. any bytes give a case or a CaseFileError with a line of the text.
///
/// Cost: linear in the text, some 10 ns a byte, as long as numbers have at most 18 digits; GMP's conversion for longer
/// ones.
Case parse_case(std::string_view text, const std::string& name);

/// Reads the file, or standard input for "-" (then "<stdin>" in messages). Throws CaseFileError when it is missing, a
/// directory, unreadable, or not a case.
Case read_case_file(const std::string& path);

/// The canonical text of a case: one directive a line, degree, grading, domain, then steps or elements in their order,
/// numbers in lowest terms. Equal cases give equal bytes. REQUIRES: a case that parse_case can give; in particular
/// explicit_mesh if and only if there are elements, and then no steps.
std::string write_case(const Case& test_case);

}  // namespace asts
