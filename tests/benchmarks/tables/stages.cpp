#include <fmt/format.h>

#include <array>
#include <span>

#include "tests/benchmarks/tables/tables.hpp"

namespace asts::benchmarks {

namespace {

/// What is shown of an input, in the order in which it happens.
constexpr std::array kStages{"read",
                             "refine",
                             "replay",
                             "closure",
                             "patches",
                             "zones",
                             "admissible",
                             "nested-patches",
                             "analysis-suitable",
                             "dual-compatible",
                             "dual-basis",
                             "check",
                             "mesh",
                             "nodes",
                             "bricks",
                             "plain-admissible",
                             "plain-nested-patches",
                             "plain-analysis-suitable",
                             "plain-dual-compatible",
                             "plain-dual-basis",
                             "plain-check",
                             "lambda-cold",
                             "lambda-warm"};
constexpr std::array kMatrixStages{
    "refine",     "closure", "zones", "admissible", "nested-patches", "analysis-suitable", "dual-compatible",
    "dual-basis", "check",   "mesh",  "nodes",      "bricks",         "plain-check"};

const Row* find(const Rows& rows, const std::string& name) {
  const auto found = rows.find(name);
  return found == rows.end() ? nullptr : &found->second;
}

std::string milliseconds(const Row* row) { return row == nullptr ? "-" : three_digits(row->seconds * 1e3); }

std::string counter(const Row* row, const char* name) {
  if (row == nullptr || !row->counters.contains(name)) return "-";
  return with_prefix(row->counters.at(name));
}

std::string growth(const Row* smaller, const Row* larger) {
  return smaller == nullptr || larger == nullptr ? "-" : three_digits(larger->seconds / smaller->seconds);
}

}  // namespace

std::string stage_table(const Rows& rows, const std::string& workload) {
  std::string result =
      "| stage | 10^4, ms | 10^5, ms | 10^6, ms | growth | elements a second | bytes an element |\n"
      "|---|---|---|---|---|---|---|\n";
  const auto size = [&](const char* elements) {
    const Row* row = find(rows, workload + "/" + elements + "/refine");
    return row == nullptr ? std::string("-") : fmt::format("{:.0f}", row->counters.at("elements"));
  };
  const auto ratio = [&]() -> std::string {
    const Row* smaller = find(rows, workload + "/100000/refine");
    const Row* larger = find(rows, workload + "/1000000/refine");
    if (smaller == nullptr || larger == nullptr) return "-";
    return three_digits(larger->counters.at("elements") / smaller->counters.at("elements"));
  };
  result +=
      fmt::format("| elements | {} | {} | {} | {} | | |\n", size("10000"), size("100000"), size("1000000"), ratio());
  for (const char* stage : kStages) {
    const auto at = [&](const char* elements) { return find(rows, workload + "/" + elements + "/" + stage); };
    if (at("10000") == nullptr && at("100000") == nullptr && at("1000000") == nullptr) continue;
    result += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", stage, milliseconds(at("10000")),
                          milliseconds(at("100000")), milliseconds(at("1000000")), growth(at("100000"), at("1000000")),
                          counter(at("1000000"), "elements/s"), counter(at("1000000"), "bytes/element"));
  }
  return result;
}

std::string matrix_table(const Rows& rows) {
  std::string result = "| input | elements |";
  std::string rule = "|---|---|";
  for (const char* stage : kMatrixStages) {
    result += fmt::format(" {} |", stage);
    rule += "---|";
  }
  result += '\n' + rule + '\n';
  const std::string last = "/refine";
  for (const auto& [name, row] : rows) {
    if (!name.ends_with(last) || name.find("/p") == std::string::npos || !row.counters.contains("elements")) continue;
    const std::string input = name.substr(0, name.size() - last.size());
    if (find(rows, input + "/closure") == nullptr) continue;
    result += fmt::format("| {} | {:.0f} |", input, row.counters.at("elements"));
    for (const char* stage : kMatrixStages)
      result += fmt::format(" {} |", milliseconds(find(rows, input + "/" + stage)));
    result += '\n';
  }
  return result;
}

std::string plain_table(const Rows& rows, const std::string& beginning) {
  std::string result = "| measured | ms | |\n|---|---|---|\n";
  for (const auto& [name, row] : rows) {
    if (!name.starts_with(beginning)) continue;
    std::string counters;
    for (const auto& [counter, value] : row.counters) {
      counters += fmt::format("{}{} {}", counters.empty() ? "" : ", ", with_prefix(value), counter);
    }
    result += fmt::format("| {} | {} | {} |\n", name, milliseconds(&row), counters);
  }
  return result;
}

std::string reference_table(const Rows& rows) {
  std::string result = "| case | elements | library, ms | literal code, ms | ratio |\n|---|---|---|---|---|\n";
  const std::string literal = "-literal";
  for (const auto& [name, row] : rows) {
    const Row* slow = find(rows, name + literal);
    if (slow == nullptr) continue;
    result += fmt::format("| {} | {:.0f} | {} | {} | {} |\n", name, row.counters.at("elements"), milliseconds(&row),
                          milliseconds(slow), three_digits(slow->seconds / row.seconds));
  }
  return result;
}

}  // namespace asts::benchmarks
