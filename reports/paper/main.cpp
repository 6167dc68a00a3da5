#include <fstream>
#include <sstream>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "reports/paper/paper.hpp"

namespace {

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  asts::require(file.good(), "the page's template cannot be read");
  return content.str();
}

void write(const std::string& path, const std::string& content) {
  std::ofstream file(path, std::ios::binary);
  file << content;
  file.close();
  asts::require(file.good(), "a figure cannot be written");
}

}  // namespace

/// paper_figures CASES TEMPLATE OUT: reads the folder tests/cases and the page's template, writes pictures, data and
/// README.md into the folder OUT. An exception ends it with its message.
int main(int argc, char** argv) {
  asts::require(argc == 4, "paper_figures CASES TEMPLATE OUT");
  const std::string cases = argv[1];
  const std::string out = argv[3];
  const asts::Paper paper = asts::make_paper({asts::read_case_file(cases + "/paper/refinement-figure.case"),
                                              asts::read_case_file(cases + "/paper/theorem-5.3-proof.case"),
                                              asts::read_case_file(cases + "/planar/published-good-tmesh.case"),
                                              asts::read_case_file(cases + "/planar/published-bad-tmesh.case")});
  for (const asts::Paper::File& file : paper.files) write(out + "/" + file.name, file.content);
  write(out + "/README.md", asts::fill_page(content_of(argv[2]), paper));
  return 0;
}
