#pragma once

#include <string>
#include <string_view>

namespace asts::cli {

/// Thrown between two pieces of work after an interrupt; what was written so far is complete.
struct Interrupted {};

/// Makes the first interrupt (SIGINT, SIGTERM) end the program at the next call of stop_if_interrupted(), and a second
/// one end it at once.
void watch_interrupts();
void stop_if_interrupted();
/// Whether there was one, for work that has something to save.
bool interrupted();

/// Writes results to stdout and hands them on at once, so that an interrupt loses nothing. Throws ResourceError when
/// they cannot be written.
void print(std::string_view text);

/// Writes something for a person to stderr.
void warn(std::string_view text);

/// A line of progress on stderr that the next one overwrites; nothing when stderr is no terminal. Empty: wipes it.
void show_progress(const std::string& line);

}  // namespace asts::cli
