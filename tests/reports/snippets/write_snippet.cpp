// write_snippet CASE ID KIND FILE: writes the program that says whether the case violates the statement in that way.
#include <fstream>

#include "lib/mesh/case_file.hpp"
#include "reports/case_snippet.hpp"

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  std::ofstream file(argv[4]);
  file << asts::case_snippet(asts::read_case_file(argv[1]), asts::find_statement(argv[2]).value(), argv[3]);
  return file.good() ? 0 : 1;
}
