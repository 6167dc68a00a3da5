#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace asts::benchmarks {

/// What Google Benchmark measured under one name.
struct Row {
  double seconds = 0;  ///< processor time of one pass; the median of the repetitions
  std::map<std::string, double> counters;
};
using Rows = std::map<std::string, Row>;

/// Adds what a file of --benchmark_format=json has, but for names that are there already. Throws
/// std::invalid_argument when the text is no such file, or a benchmark ended with an error.
void add_rows(std::string_view json, Rows& rows);

/// What time_processes measured of one command.
struct Process {
  double seconds = 0;  ///< on the clock on the wall; the median of the rounds
  double cpu_seconds = 0;
  double peak_bytes = 0;
  int exit_code = 0;
};
using Processes = std::map<std::string, Process>;

/// Adds what the lines say. Throws as above.
void add_processes(std::string_view lines, Processes& processes);

/// REQUIRES: not empty. The lower one of the two in the middle when there is no middle.
double median(std::vector<double> values);

}  // namespace asts::benchmarks
