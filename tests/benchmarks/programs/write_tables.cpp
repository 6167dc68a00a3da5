#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "tests/benchmarks/tables/tables.hpp"

/// write_tables FILE...: Markdown tables of what was measured. A FILE.json is Google Benchmark's (of two that have a
/// name the first counts), a FILE.jsonl that of time_processes.
namespace asts::benchmarks {
namespace {

std::string content_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream content;
  if (!file || !(content << file.rdbuf())) throw std::invalid_argument("it cannot be read");
  return content.str();
}

void write(const Rows& rows, const Processes& processes) {
  std::cout << "## Promises\n" << promises_table(rows, processes);
  std::cout << "\n## The program\n" << process_table(processes);
  for (const std::string workload : {"sphere/p3/m2", "corner/p3/m2", "random/p3/m2"}) {
    std::cout << "\n## Stages of `" << workload << "`\n" << stage_table(rows, workload);
  }
  std::cout << "\n## All inputs, ms\n" << matrix_table(rows);
  std::cout << "\n## p8est\n" << plain_table(rows, "p8est/");
  std::cout << "\n## Sequences of single marks\n";
  Rows steps;
  for (const auto& [name, row] : rows) {
    if (name.find("/steps-") != std::string::npos) steps[name] = row;
  }
  std::cout << plain_table(steps, "");
  std::cout << "\n## Enumerations\n" << plain_table(rows, "enumerate/");
  std::cout << "\n## Campaigns\n" << plain_table(rows, "campaign/");
  std::cout << "\n## Minimization\n" << plain_table(rows, "minimize/");
  std::cout << "\n## The literal code\n" << reference_table(rows);
}

}  // namespace
}  // namespace asts::benchmarks

int main(int argc, char** argv) {
  using namespace asts::benchmarks;
  Rows rows;
  Processes processes;
  for (const std::string& path : std::vector<std::string>(argv + 1, argv + argc)) {
    try {
      if (path.ends_with(".jsonl")) {
        add_processes(content_of(path), processes);
      } else {
        add_rows(content_of(path), rows);
      }
    } catch (const std::invalid_argument& error) {
      std::cerr << "write_tables: " << path << ": " << error.what() << '\n';
      return 2;
    }
  }
  write(rows, processes);
  return 0;
}
