#include "properties/claims/case_table.hpp"
#include "reports/paper/paper.hpp"

namespace asts {

namespace {

/// The conditions of the five cases, for v_1, v_2 in N_y(r) and v_3, v_4 in N_x(q).
std::vector<int> applying(const std::array<bool, 4>& heads) {
  const auto [v1, v2, v3, v4] = heads;
  const std::array conditions{v1 != v2, v1 && !v4, !v1 && !v3, v2 && v4, !v2 && v3};
  std::vector<int> result;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (conditions[i]) result.push_back(static_cast<int>(i) + 1);
  }
  return result;
}

std::string numbers(const std::vector<int>& cases) {
  std::string text;
  for (const int one : cases) text += (text.empty() ? "" : ", ") + std::to_string(one);
  return text;
}

/// As printed all heads ask for N_y(r), where v_3 is and v_4 is not.
bool can_occur_as_printed(const std::array<bool, 4>& heads) { return heads[2] && !heads[3]; }

}  // namespace

void add_case_table(Paper& paper) {
  std::vector<std::vector<std::string>> rows{{"v1 in Ny(r)", "v2 in Ny(r)", "v3 in ...", "v4 in ...", "cases, paper",
                                              "cases, here, heads Nx(q)", "can occur with the printed heads Ny(r)"}};
  for (const CaseRow& row : printed_case_table()) {
    std::vector<std::string> cells;
    for (const bool head : row.heads) cells.push_back(head ? "true" : "false");
    cells.push_back(numbers(row.cases));
    cells.push_back(numbers(applying(row.heads)));
    cells.push_back(can_occur_as_printed(row.heads) ? "yes" : "no");
    rows.push_back(cells);
  }
  paper.tables["cases"] = markdown_table(rows);
}

}  // namespace asts
