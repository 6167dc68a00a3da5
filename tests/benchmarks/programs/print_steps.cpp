#include <cstdlib>
#include <iostream>
#include <string>

#include "lib/mesh/case_file.hpp"
#include "tests/benchmarks/inputs.hpp"

/// print_steps WORKLOAD ELEMENTS STEPS: the case of a workload (p = 3,3,3, m = 2) with that many single-mark steps
/// more.
int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: print_steps WORKLOAD ELEMENTS STEPS\n";
    return 2;
  }
  const asts::benchmarks::Input input{asts::workload_named(argv[1]), 3, 2, std::atoll(argv[2])};
  std::cout << asts::write_case(asts::benchmarks::with_single_marks(input, std::atoi(argv[3])));
  return 0;
}
