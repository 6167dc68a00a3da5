#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "lib/minimize/minimize.hpp"
#include "properties/statement.hpp"
#include "tests/minimize/planted_faults.hpp"
#include "tests/minimize/rapidcheck_shrink.hpp"
#include "tests/minimize/start_cases.hpp"
#include "tests/minimize/start_meshes.hpp"

// How small the start cases get, in how many evaluations of what they violate, with rapidcheck's own shrinker beside
// it, as a Markdown table. Arguments: the number of seeds (20), the most evaluations of either (20000), then the rows
// wanted (all; "boxes" behind an id for its explicit starts). A row tells the sizes that were reached, and how often.

namespace asts {
namespace {

struct Row {
  std::string name;
  PathForm form;
  Predicate violation;
  std::function<Case(std::uint64_t)> start;
};

Row row_of(std::string_view id, bool boxes) {
  const Statement statement = find_statement(id).value();
  return {std::string(id) + (boxes ? " boxes" : ""), statement.of_sequence() ? PathForm::sequence : PathForm::mesh,
          [=](const Case& test_case) { return violation_of(statement, test_case); },
          [=](std::uint64_t seed) { return boxes ? violating_explicit_start(id, seed) : violating_start(id, seed); }};
}

std::vector<Row> all_rows() {
  std::vector<Row> rows;
  for (const std::string_view id : start_claims()) rows.push_back(row_of(id, false));
  for (const std::string_view id : explicit_start_ids()) rows.push_back(row_of(id, true));
  for (const PlantedFault& fault : planted_faults()) {
    rows.push_back({fault.name, fault.form, fault.predicate, fault.start});
  }
  return rows;
}

/// Elements subdivided in the last mesh, or, of an explicit mesh, all its boxes, which may get fewer than the unit
/// cubes; then the domain's volume and m.
struct Size {
  bool boxes;
  std::int64_t count;
  std::int64_t volume;
  int grading;

  friend auto operator<=>(const Size&, const Size&) = default;
};

Size shown_size(const Case& test_case) {
  std::int64_t volume = 1;
  for (const int side : test_case.domain) volume *= side;
  const bool boxes = test_case.explicit_mesh;
  const std::int64_t count = boxes ? static_cast<std::int64_t>(test_case.elements.size()) : size_of(test_case);
  return {boxes, count, volume, test_case.grading};
}

/// What one of the two shrinkers did with a row's starts.
struct Column {
  std::map<Size, int> sizes;
  std::vector<std::int64_t> evaluations;
  double seconds = 0;

  std::int64_t median() {
    std::sort(evaluations.begin(), evaluations.end());
    return evaluations[evaluations.size() / 2];
  }
  /// At most four, the smallest first, and how many more there are.
  std::string sizes_text() const {
    constexpr int kShown = 4;
    std::string text;
    int shown = 0;
    for (const auto& [size, count] : sizes) {
      if (shown++ == kShown) return text + fmt::format(", and {} more sizes", sizes.size() - kShown);
      text += (text.empty() ? "" : ", ") +
              fmt::format("{}{}/{}/{} ({})", size.count, size.boxes ? " boxes" : "", size.volume, size.grading, count);
    }
    return text;
  }
};

template <class Shrink>
void measure(Column& column, const Shrink& shrink) {
  const auto begin = std::chrono::steady_clock::now();
  const auto [size, evaluations] = shrink();
  column.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ++column.sizes[size];
  column.evaluations.push_back(evaluations);
}

void print_row(const Row& row, std::uint64_t seeds, std::int64_t cap) {
  using Result = std::pair<Size, std::int64_t>;
  std::set<std::string> kinds;
  std::set<std::string> guarantees;
  Column ours;
  Column theirs;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Case start = row.start(seed);
    const ViolationKind kind = row.violation(start);
    kinds.insert(kind.value());
    measure(ours, [&]() -> Result {
      const Minimized result = minimize(start, row.form, row.violation, {cap, {}, {}});
      guarantees.insert(guarantee_name(result.guarantee));
      return {shown_size(result.smallest), result.evaluations};
    });
    measure(theirs, [&]() -> Result {
      const auto fails = [&](const Case& other) { return row.violation(other) == kind; };
      const Shrunk result = shrink_with_rapidcheck(start, fails, cap);
      return {shown_size(result.smallest), result.evaluations};
    });
  }
  const auto joined = [](const std::set<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
  };
  const std::int64_t median = ours.median();
  const std::int64_t their_median = theirs.median();
  fmt::print("| {} | {} | {} | {} | {} | {} | {:.1f} | {} | {} | {:.1f} |\n", row.name, joined(kinds),
             ours.sizes_text(), joined(guarantees), median, ours.evaluations.back(), ours.seconds, theirs.sizes_text(),
             their_median, theirs.seconds);
  std::fflush(stdout);
}

}  // namespace
}  // namespace asts

int main(int argc, char** argv) {
  const std::uint64_t seeds = argc > 1 ? std::stoull(argv[1]) : 20;
  const std::int64_t cap = argc > 2 ? std::stoll(argv[2]) : 20'000;
  const std::set<std::string> wanted(argv + std::min(argc, 3), argv + argc);
  fmt::print(
      "| start | kind | subdivisions/volume/m (how often) | guarantee | evaluations, median | most | s | rapidcheck: "
      "subdivisions/volume/m | "
      "median | s |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const asts::Row& row : asts::all_rows()) {
    if (wanted.empty() || wanted.contains(row.name)) asts::print_row(row, seeds, cap);
  }
}
