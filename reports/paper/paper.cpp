#include "reports/paper/paper.hpp"

#include <set>
#include <sstream>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_prefix.hpp"
#include "lib/refine/replay.hpp"

namespace asts {

Paper make_paper(const PaperCases& cases) {
  Paper paper;
  add_patch_examples(cases, paper);
  add_subdivisions(paper);
  add_refinement_iterations(cases, paper);
  add_example_meshes(paper);
  add_skeletons(cases, paper);
  add_planar_examples(cases, paper);
  add_proof_levels(cases, paper);
  add_proof_perturbations(paper);
  add_perfect_bsplines(paper);
  add_case_table(paper);
  add_complexity(paper);
  return paper;
}

std::string fill_page(const std::string& page, const Paper& paper) {
  const std::string begin = "@TABLE ";
  std::set<std::string> named;
  std::istringstream lines(page);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(begin) && line.ends_with('@')) {
      const std::string name = line.substr(begin.size(), line.size() - begin.size() - 1);
      require(paper.tables.contains(name), "the page names a table that there is not");
      named.insert(name);
      result += paper.tables.at(name);
    } else {
      result += line + "\n";
    }
  }
  require(named.size() == paper.tables.size(), "the page leaves out a table");
  return result;
}

RefinementTree mesh_after(const Case& sequence, std::size_t steps) {
  const Case part = case_prefix(sequence, steps);
  Replay replay(part);
  while (!replay.done()) replay.advance();
  return replay.tree();
}

std::string markdown_table(const std::vector<std::vector<std::string>>& rows) {
  std::string result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result += "|";
    for (const std::string& cell : rows[i]) result += " " + cell + " |";
    result += "\n";
    if (i > 0) continue;
    result += "|";
    for (std::size_t k = 0; k < rows[0].size(); ++k) result += "---|";
    result += "\n";
  }
  return result;
}

}  // namespace asts
