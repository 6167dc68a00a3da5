#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

/// fuzz/faults: every planted fault can still be planted, and the table says that each was caught.
namespace asts::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = fs::weakly_canonical(fs::path(ASTS_CASES) / ".." / "..");

std::string content_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

std::vector<std::string> lines_of(const fs::path& path) {
  std::istringstream content(content_of(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(content, line);) lines.push_back(line);
  return lines;
}

/// A patch of one hunk.
struct Fault {
  std::string name;
  std::string header;  ///< its first line, "class: what is wrong"
  std::string file;
  std::string before;  ///< the lines it expects to find
  std::string after;   ///< and what it makes of them
};

Fault read_fault(const fs::path& path) {
  Fault fault{path.stem().string(), "", "", "", ""};
  int hunks = 0;
  for (const std::string& line : lines_of(path)) {
    if (fault.header.empty()) fault.header = line;
    if (line.starts_with("+++ b/")) fault.file = line.substr(6);
    hunks += line.starts_with("@@");
    if (hunks == 0 || line.starts_with("@@")) continue;
    if (line[0] != '+') fault.before += line.substr(1) + "\n";
    if (line[0] != '-') fault.after += line.substr(1) + "\n";
  }
  EXPECT_EQ(hunks, 1) << path;
  return fault;
}

std::vector<Fault> all_faults() {
  std::vector<Fault> faults;
  for (const auto& entry : fs::directory_iterator(kRoot / "fuzz" / "faults")) {
    if (entry.path().extension() == ".patch") faults.push_back(read_fault(entry.path()));
  }
  return faults;
}

std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Faults, EachFitsExactlyOnePlaceOfItsFile) {
  const std::vector<Fault> faults = all_faults();
  EXPECT_GE(faults.size(), 44U);
  for (const Fault& fault : faults) {
    EXPECT_EQ(count_of("\n" + fault.before, content_of(kRoot / fault.file)), 1U) << fault.name << " in " << fault.file;
    EXPECT_NE(fault.before, fault.after) << fault.name;
    EXPECT_NE(fault.header.find(": "), std::string::npos) << fault.name;
  }
}

TEST(Faults, TheyAreInEveryFolderThatTheyAreMeantFor) {
  std::map<std::string, int> folders;
  for (const Fault& fault : all_faults()) ++folders[fs::path(fault.file).parent_path().string()];
  for (const char* folder : {"lib/exact", "lib/mesh", "lib/refine", "lib/spline", "lib/gen", "lib/minimize",
                             "properties", "properties/claims"}) {
    EXPECT_GE(folders[folder], 3) << folder;
  }
}

/// The cells of a row "| a | b |".
std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream rest(row.substr(1));
  for (std::string cell; std::getline(rest, cell, '|');) {
    if (cell.size() >= 2) cells.push_back(cell.substr(1, cell.size() - 2));
  }
  return cells;
}

TEST(Faults, TheTableHasARowForEachAndAllAreCaught) {
  std::map<std::string, std::vector<std::string>> rows;
  const std::vector<std::string> lines = lines_of(kRoot / "fuzz" / "faults" / "table.md");
  for (const std::string& line : lines) {
    if (!line.starts_with("| ") || line.starts_with("| fault ")) continue;
    const std::vector<std::string> cells = cells_of(line);
    ASSERT_EQ(cells.size(), 7U) << line;
    EXPECT_TRUE(rows.try_emplace(cells[0], cells).second) << "twice: " << cells[0];
  }
  const std::vector<Fault> faults = all_faults();
  EXPECT_EQ(rows.size(), faults.size());
  for (const Fault& fault : faults) {
    ASSERT_TRUE(rows.contains(fault.name)) << fault.name;
    const std::vector<std::string>& row = rows[fault.name];
    EXPECT_EQ(row[1], fault.header.substr(0, fault.header.find(": "))) << fault.name;
    EXPECT_EQ(row[2], fault.file) << fault.name;
    EXPECT_NE(row[3], "-") << fault.name << " is caught by no test";
  }
  const std::string all = std::to_string(faults.size());
  EXPECT_EQ(lines.back(), all + " of " + all + " caught");
}

}  // namespace
}  // namespace asts::testing
