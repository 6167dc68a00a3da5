#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "lib/mesh/case_file.hpp"

namespace asts {

/// Throws CaseFileError with "NAME:LINE: reason".
[[noreturn]] void fail_at(const std::string& name, std::size_t line, const std::string& reason);

/// A word of the file as messages show it: every byte that is not printable ASCII as \xHH, so that a message never
/// carries control characters to a terminal; a long word by its beginning and its length.
std::string shown(std::string_view word);

/// The same in quotes.
std::string quote(std::string_view word);

/// The next word of `rest`, which loses it; empty when there is none. Blanks and tabs separate words.
inline std::string_view next_word(std::string_view& rest) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end])) ++end;
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

/// Splits `rest` into words; stores the first words.size() of them and returns how many there are in all.
std::size_t split(std::string_view rest, std::span<std::string_view> words);

/// The lines of a case text that say something, in order: without comments, line ends (LF or CRLF), a byte order mark
/// at the beginning, and without the lines that are blank then. Refuses NUL bytes and invalid UTF-8, in comments too,
/// when it comes to the line that has them, so that the first line at fault is the one reported.
class CaseLines {
 public:
  CaseLines(std::string_view text, const std::string& name);

  /// Moves to the next line; false at the end, where number() stays that of the last line.
  bool next();

  /// REQUIRES: the last call of next() returned true. Has at least one word.
  std::string_view line() const { return line_; }
  /// The number of the line, counted from 1; 1 for an empty text.
  std::size_t number() const { return number_ == 0 ? 1 : number_; }

  [[noreturn]] void fail(const std::string& reason) const { fail_at(name_, number(), reason); }

 private:
  void take_line();

  const std::string& name_;
  std::string_view text_;
  std::size_t next_ = 0;  ///< where the next line begins
  std::size_t bad_;       ///< the first byte that no text has, text_.size() when there is none
  std::string_view line_;
  std::size_t number_ = 0;
};

}  // namespace asts
