#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>

#include "lib/refine/complexity_constants.hpp"
#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

const fs::path kRoot = fs::weakly_canonical(fs::path(ASTS_CASES) / ".." / "..");

Names matches_of(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  Names matches;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match) {
    matches.push_back((*match)[1]);
  }
  return matches;
}

/// A page without what Markdown shows as it stands: fenced blocks and inline code.
std::string prose_of(const std::string& text) {
  return std::regex_replace(std::regex_replace(text, std::regex("```[^]*?```"), ""), std::regex("`[^`\n]*`"), "");
}

std::vector<fs::path> pages() {
  std::vector<fs::path> pages{kRoot / "README.md", kRoot / "CONTRIBUTING.md", kRoot / "CHANGELOG.md"};
  for (const char* folder : {"reports", "fuzz"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (entry.path().extension() == ".md") pages.push_back(entry.path());
    }
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

bool leads_away(const std::string& link) { return link.starts_with("https://") || link.starts_with("http://"); }

TEST(Pages, EveryLinkLeadsToAFile) {
  int followed = 0;
  for (const fs::path& page : pages()) {
    for (const std::string& link : matches_of(prose_of(content_of(page.string())), R"(\]\(([^)#\s]+)[^)]*\))")) {
      if (leads_away(link)) continue;
      EXPECT_TRUE(fs::exists(page.parent_path() / link)) << page << " links to " << link;
      ++followed;
    }
  }
  EXPECT_GT(followed, 60);
}

std::string index_page() { return content_of((kRoot / "reports/README.md").string()); }

struct IndexRow {
  std::string link;
  Names commands;
};

/// The rows of the table of pages.
std::vector<IndexRow> index_rows() {
  std::vector<IndexRow> rows;
  for (const std::string& line : lines_of(index_page())) {
    if (!line.starts_with("| [")) continue;
    rows.push_back({matches_of(line, R"(\]\(([^)]+)\))").at(0), matches_of(line, "`([^`]+)` \\|$")});
  }
  return rows;
}

TEST(ReportsIndex, ThePagesHaveTheirCommands) {
  const auto rows = index_rows();
  EXPECT_GE(rows.size(), 9U);
  for (const IndexRow& row : rows) {
    const std::string page = content_of((kRoot / "reports" / row.link).string());
    for (const std::string& command : row.commands) {
      EXPECT_NE(page.find(command), std::string::npos) << row.link << " does not say: " << command;
    }
  }
}

TEST(ReportsIndex, NamesEveryPage) {
  Names links;
  for (const IndexRow& row : index_rows()) links.push_back(fs::weakly_canonical(kRoot / "reports" / row.link));
  for (const auto& entry : fs::directory_iterator(kRoot / "reports")) {
    fs::path page = entry.path();
    if (entry.is_directory()) page /= "README.md";
    if (page.extension() != ".md" || !fs::exists(page) || page == kRoot / "reports/README.md") continue;
    EXPECT_NE(std::find(links.begin(), links.end(), page.string()), links.end()) << page;
  }
}

/// What stands between "<!-- NAME -->" and "<!-- end -->".
std::string table_of(const std::string& name) {
  const std::string page = index_page();
  const std::string begin = "<!-- " + name + " -->\n";
  const std::size_t first = page.find(begin) + begin.size();
  return page.substr(first, page.find("<!-- end -->", first) - first);
}

nlohmann::ordered_json last_step(const Names& arguments, const std::string& input = {}) {
  return records_of(run(arguments, input).out).back();
}

TEST(ReportsIndex, ThePapersTableIsWhatTheProgramPrints) {
  struct Row {
    int m, steps, new_elements;
  };
  std::string table =
      "| m | steps in the paper | steps here | new elements in the paper | new elements here "
      "|\n|---|---|---|---|---|\n";
  for (const Row& paper : {Row{2, 12, 10728}, Row{4, 6, 3175}, Row{16, 3, 1030}}) {
    const auto last =
        last_step({"refine", case_path(fmt::format("paper/example-2.10-m{}.case", paper.m)), "--format", "json"});
    table += fmt::format("| {} | {} | {} | {} | {} |\n", paper.m, paper.steps, last["step"].get<int>(),
                         paper.new_elements, last["new_elements"].get<int>());
  }
  EXPECT_EQ(table_of("example 2.10"), table);
}

/// "| NEW ELEMENTS | A MARK ", rounded down.
std::string ratio_after(int m, int steps) {
  std::string text = fmt::format("asts-case 1\ndegree 3 3 3\ngrading {}\ndomain 5 5 5\n", m);
  for (int step = 0; step < steps; ++step) text += "refine 0 0 0\n";
  const auto count = last_step({"refine", "-", "--format", "json"}, text)["new_elements"].get<std::int64_t>();
  const std::int64_t digits = count * 10000 / steps;
  return fmt::format("| {} | {}.{:04} ", count, digits / 10000, digits % 10000);
}

TEST(ReportsIndex, TheExperimentIsWhatTheProgramPrints) {
  std::string table =
      "| m | new elements after 30 steps | a mark | new elements after 120 steps | a mark | C/3000 |\n"
      "|---|---|---|---|---|---|\n";
  for (int m = 2; m <= 5; ++m) {
    const CubeRootNumber bound = complexity_constant(distance_constants({3, 3, 3}, m)) * Rational(1, 3000);
    table +=
        fmt::format("| {} {}{}| {} |\n", m, ratio_after(m, 30), ratio_after(m, 120), enclose_decimal(bound, 8).lower);
  }
  EXPECT_EQ(table_of("experiment"), table);
}

}  // namespace
}  // namespace asts::testing
