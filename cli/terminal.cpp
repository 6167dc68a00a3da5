#include "cli/terminal.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "lib/exact/errors.hpp"

namespace asts::cli {

namespace {

volatile std::sig_atomic_t interrupts = 0;

void on_interrupt(int signal) {
  interrupts = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

bool interrupted() { return interrupts != 0; }

void stop_if_interrupted() {
  if (interrupted()) throw Interrupted{};
}

void print(std::string_view text) {
  if (text.empty()) return;
  show_progress({});
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw ResourceError("standard output cannot be written");
  }
}

void warn(std::string_view text) {
  show_progress({});
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void show_progress(const std::string& line) {
  static const bool terminal = isatty(STDERR_FILENO) != 0;
  static bool shown = false;
  if (!terminal || (line.empty() && !shown)) return;
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
  shown = !line.empty();
}

}  // namespace asts::cli
