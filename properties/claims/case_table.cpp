#include "properties/claims/case_table.hpp"

#include <algorithm>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

/// v_1, v_2 in N_y(r); v_3, v_4 in N_x(q).
using Situation = std::array<bool, 4>;

constexpr bool kTrue = true;
constexpr bool kFalse = false;

/// The conditions of the proof's cases.
std::vector<int> applicable(const Situation& situation) {
  const auto [v1, v2, v3, v4] = situation;
  const std::array conditions{v1 != v2, v1 && !v4, !v1 && !v3, v2 && v4, !v2 && v3};
  std::vector<int> result;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (conditions[i]) result.push_back(static_cast<int>(i) + 1);
  }
  return result;
}

std::array<bool, 4> heads_of(const Situation& situation, CaseHeads heads) {
  if (heads == CaseHeads::repaired) return situation;
  return {situation[0], situation[1], true, false};
}

const CaseRow& row_of(std::span<const CaseRow> table, const std::array<bool, 4>& heads) {
  const auto row = std::find_if(table.begin(), table.end(), [&](const CaseRow& one) { return one.heads == heads; });
  ensure(row != table.end(), "the table has a row for all heads");
  return *row;
}

std::string text_of(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : ", ") + std::to_string(number);
  return text.empty() ? "none" : text;
}

std::string text_of(const Situation& situation) {
  constexpr std::array kQuestions{"v1 in N_y(r)", "v2 in N_y(r)", "v3 in N_x(q)", "v4 in N_x(q)"};
  std::string text;
  for (std::size_t i = 0; i < situation.size(); ++i) {
    text += std::string(i == 0 ? "" : ", ") + kQuestions[i] + ": " + (situation[i] ? "true" : "false");
  }
  return text;
}

}  // namespace

std::span<const CaseRow> printed_case_table() {
  static const std::vector<CaseRow> kRows{
      {{kTrue, kTrue, kTrue, kTrue}, {4}},         {{kTrue, kTrue, kTrue, kFalse}, {2}},
      {{kTrue, kTrue, kFalse, kTrue}, {4}},        {{kTrue, kTrue, kFalse, kFalse}, {2}},
      {{kTrue, kFalse, kTrue, kTrue}, {1, 5}},     {{kTrue, kFalse, kTrue, kFalse}, {1, 2, 5}},
      {{kTrue, kFalse, kFalse, kTrue}, {1}},       {{kTrue, kFalse, kFalse, kFalse}, {1, 2}},
      {{kFalse, kTrue, kTrue, kTrue}, {1, 4}},     {{kFalse, kTrue, kTrue, kFalse}, {1}},
      {{kFalse, kTrue, kFalse, kTrue}, {1, 3, 4}}, {{kFalse, kTrue, kFalse, kFalse}, {1, 3}},
      {{kFalse, kFalse, kTrue, kTrue}, {5}},       {{kFalse, kFalse, kTrue, kFalse}, {5}},
      {{kFalse, kFalse, kFalse, kTrue}, {3}},      {{kFalse, kFalse, kFalse, kFalse}, {3}},
  };
  return kRows;
}

Trial judge_case_table(std::span<const CaseRow> table, CaseHeads heads) {
  Trial trial;
  std::int64_t wrong = 0;
  ClaimWitness witness{
      "case-table-disagrees", "the table's row for a situation does not list the cases that apply", {}};
  for (unsigned bits = 0; bits < 16; ++bits) {
    const Situation situation{(bits & 8) == 0, (bits & 4) == 0, (bits & 2) == 0, (bits & 1) == 0};
    const std::vector<int> cases = applicable(situation);
    const CaseRow& row = row_of(table, heads_of(situation, heads));
    ++trial.met;
    if (!cases.empty() && row.cases == cases) continue;
    if (wrong++ > 0) continue;
    witness.values = {{"situation", text_of(situation)}, {"listed", text_of(row.cases)}, {"applying", text_of(cases)}};
  }
  if (wrong == 0) return trial;
  witness.values.emplace_back("situations", trial.met);
  witness.values.emplace_back("wrong", wrong);
  return {Verdict::violated(std::move(witness)), trial.met};
}

Trial case_table(Extent) { return judge_case_table(printed_case_table(), CaseHeads::printed); }

Trial case_table_repaired(Extent) { return judge_case_table(printed_case_table(), CaseHeads::repaired); }

}  // namespace asts
