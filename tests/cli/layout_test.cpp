#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

namespace asts::testing {
namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

const fs::path kRoot = fs::weakly_canonical(fs::path(ASTS_CASES) / ".." / "..");

/// The arrows: the files of a folder may include files of these folders (or these files), and no others of the project.
const std::map<std::string, Names> kArrows{
    {"lib/exact", {"lib/exact/"}},
    {"lib/mesh", {"lib/exact/", "lib/threads/", "lib/mesh/"}},
    {"lib/threads", {"lib/threads/"}},
    {"lib/refine", {"lib/exact/", "lib/threads/", "lib/mesh/", "lib/refine/"}},
    {"lib/spline", {"lib/exact/", "lib/mesh/", "lib/spline/"}},
    {"lib/zones", {"lib/exact/", "lib/threads/", "lib/mesh/", "lib/spline/", "lib/zones/"}},
    {"lib/minimize", {"lib/exact/", "lib/mesh/", "lib/refine/", "lib/gen/", "lib/minimize/"}},
    {"lib/gen", {"lib/exact/", "lib/mesh/", "lib/refine/", "lib/gen/"}},
    {"properties", {"lib/", "properties/"}},
    {"reports", {"lib/", "properties/", "reports/"}},
    {"fuzz", {"lib/", "properties/", "reports/", "fuzz/", "tests/reference/"}},
    {"cli", {"lib/", "properties/", "reports/", "fuzz/", "cli/", "tests/reference/"}},
    {"tests/reference", {"lib/exact/rational.hpp", "tests/reference/"}},
};

std::string content_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

/// The C++ files below a folder but for tests, which may compare anything with anything.
std::vector<fs::path> sources_in(const std::string& folder) {
  std::vector<fs::path> sources;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
    const std::string name = entry.path().filename().string();
    const bool source = entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp";
    if (source && !name.ends_with("_test.cpp")) sources.push_back(entry.path());
  }
  return sources;
}

Names includes_of(const std::string& text) {
  static const std::regex line(R"re(#include\s+"([^"]+)")re");
  Names includes;
  for (std::sregex_iterator match(text.begin(), text.end(), line), end; match != end; ++match) {
    includes.push_back((*match)[1]);
  }
  return includes;
}

bool may_include(const std::string& folder, const std::string& file) {
  const Names& allowed = kArrows.at(folder);
  return std::any_of(allowed.begin(), allowed.end(), [&](const std::string& begin) { return file.starts_with(begin); });
}

TEST(Layout, IncludesFollowTheArrows) {
  for (const auto& [folder, allowed] : kArrows) {
    const std::vector<fs::path> sources = sources_in(folder);
    EXPECT_FALSE(sources.empty()) << folder;
    for (const fs::path& source : sources) {
      for (const std::string& file : includes_of(content_of(source))) {
        EXPECT_TRUE(may_include(folder, file)) << source << " includes " << file;
        EXPECT_TRUE(fs::exists(kRoot / file)) << source << " includes " << file << " not by its path from the root";
      }
    }
  }
}

// A new folder of lib/ needs its arrows written down above.
TEST(Layout, EveryFolderOfLibHasItsArrows) {
  for (const auto& entry : fs::directory_iterator(kRoot / "lib")) {
    const std::string folder = "lib/" + entry.path().filename().string();
    if (!entry.is_directory()) continue;
    EXPECT_TRUE(kArrows.contains(folder)) << folder;
  }
}

/// Code without comments and the contents of string literals.
std::string code_of(const std::string& text) {
  static const std::regex noise(R"re(//[^\n]*|/\*([^*]|\*[^/])*\*/|"(\\.|[^"\\\n])*")re");
  return std::regex_replace(text, noise, " ");
}

// Exact, always: no floating-point number decides anything.
TEST(Layout, LibAndPropertiesHaveNoFloatingPointNumbers) {
  static const std::regex words(R"re(\b(double|float)\b)re");
  for (const char* folder : {"lib", "properties"}) {
    for (const fs::path& source : sources_in(folder)) {
      EXPECT_FALSE(std::regex_search(code_of(content_of(source)), words)) << source;
    }
  }
}

// Results are printed in one place: cli/terminal.cpp.
TEST(Layout, LibAndPropertiesAndReportsPrintNothing) {
  static const std::regex words(R"re(\b(cout|cerr|clog|printf|puts|fputs|fwrite|iostream|exit|abort)\b)re");
  for (const char* folder : {"lib", "properties", "reports"}) {
    for (const fs::path& source : sources_in(folder)) {
      EXPECT_FALSE(std::regex_search(code_of(content_of(source)), words)) << source;
    }
  }
}

}  // namespace
}  // namespace asts::testing
