#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "lib/exact/compact_rational.hpp"
#include "lib/mesh/case_text.hpp"

namespace asts {

/// a < b, exactly. No allocation where both numbers are small.
bool less(const CompactRational& a, const CompactRational& b);

/// The number in `word`, or CaseFileError at the current line.
CompactRational number_in(const CaseLines& lines, std::string_view word);

/// The integer in `word` between low and high, or CaseFileError at the current line; `what` names it there.
/// REQUIRES: low and high fit into an int.
int integer_in(const CaseLines& lines, const std::string& what, std::string_view word, std::int64_t low,
               std::int64_t high);

/// CaseFileError at the current line unless count == expected; `needs` says what is needed.
void require_count(const CaseLines& lines, std::size_t count, std::size_t expected, const char* needs);

}  // namespace asts
